// SPDX-License-Identifier: MIT
// A mesh that is not flat, made flat and edited at one door, opens and verifies at every other.
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { exportAs, idle, openFile, status, typeTarget } from "../browser/support/page.ts";
import { site } from "../browser/support/site.ts";
import { NIGHTLY } from "../patience.ts";
import { PYTHON, ROOT } from "./support/places.ts";

const CLI = join(ROOT, "build/native/planish");
const SHARED = join(ROOT, "../shared/meshes");

/** Quads 1 m apart over `height`, whose panels are not flat. */
function quads(size: number, height: (x: number, y: number) => number): string {
  const lines: string[] = [];
  for (let i = 0; i <= size; ++i)
    for (let j = 0; j <= size; ++j)
      lines.push(`v ${i} ${j + 0.03 * i * j} ${height(i / size - 0.5, j / size - 0.5)}`);
  const at = (i: number, j: number): number => i * (size + 1) + j + 1;
  for (let i = 0; i < size; ++i)
    for (let j = 0; j < size; ++j)
      lines.push(`f ${at(i, j)} ${at(i + 1, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}`);
  return `${lines.join("\n")}\n`;
}

/** Every third point of the sample of hexagons stands out by 4 mm. */
function bumpyHexagons(): string {
  const text = execFileSync(CLI, ["sample", "hex", "--size", "8", "-o", "-"]).toString();
  let point = 0;
  return text.replaceAll(/^(v \S+ \S+ )(\S+)$/gm, (_, start: string, z: string) => {
    point += 1;
    return `${start}${Number(z) + (point % 3 === 0 ? 0.004 : 0)}`;
  });
}

const DRAWN: Readonly<Record<string, () => string>> = {
  "dome.obj": () => quads(10, (x, y) => 2 * Math.cos(2.6 * x) * Math.cos(2.6 * y)),
  "wave.obj": () => quads(9, (x, y) => 1.5 * Math.cos(3 * x) + 0.8 * y * y + 0.15 * x * y),
  "hexagons.obj": bumpyHexagons,
};
/** Real ones take minutes together: every night, where they are. */
const FILES = ["mixed345_airport.obj", "pq_botanic_bubble.obj", "pq_static_roof.obj"];

/** Milliseconds for one mesh at every door. */
const PATIENCE = 240_000;

let folder = "";
beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), "planish-planarised-"));
});
afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** The design that the page saves once the mesh is flat and a point of it was raised. */
async function madeOnThePage(name: string, mesh: string): Promise<string> {
  const page = await site.open();
  await openFile(page, name, mesh);
  await page.getByRole("button", { name: "Planarise", exact: true }).click();
  await page.getByRole("button", { name: "Start editing" }).click({ timeout: PATIENCE });
  await idle(page);
  await typeTarget(page, "+10cm");
  await idle(page);
  expect(await status(page)).toMatch(/[1-9]\d* of \d+ points move .*flat/);
  const text = (await exportAs(page, "JSON")).toString();
  await page.context().close();
  return text;
}

/** Up to which a door of the other build differs from the record: rounding, in edges of about 1. */
const ROUNDING = 1e-9;

/** What each door says of a saved design. */
async function opened(text: string): Promise<Record<string, boolean>> {
  const path = join(folder, "design.json");
  writeFileSync(path, text);
  const report = join(folder, "report.json");
  execFileSync(CLI, ["replay", path, "--report", report], { stdio: "pipe" });
  const command = JSON.parse(readFileSync(report, "utf8"));
  const code = "import planish, sys; print(planish.Design.load(sys.argv[1]).replay().deviation)";
  const python = Number(execFileSync(PYTHON, ["-c", code, path]).toString());
  const { Design } = await import(join(ROOT, "build/npm/node.js"));
  const npm = (await Design.read(text)).replay();
  const page = await site.open();
  await openFile(page, "design.json", text);
  const says = (await page.getByText(/^(Verified: .*|Replayed: .* rounding\.)$/).count()) === 1;
  await page.context().close();
  return {
    command: command.deviation <= ROUNDING,
    python: python <= ROUNDING,
    npm: npm.deviation <= ROUNDING,
    page: says,
  };
}

const EVERYWHERE = { command: true, python: true, npm: true, page: true };

/** Made on the page, then recorded by the command, whose build is the other one. */
async function holdEverywhere(name: string, mesh: string): Promise<void> {
  const made = await madeOnThePage(name, mesh);
  expect(await opened(made), "made on the page").toEqual(EVERYWHERE);
  const [path, again] = [join(folder, "made.json"), join(folder, "again.json")];
  writeFileSync(path, made);
  execFileSync(CLI, ["replay", path, "--design", again], { stdio: "pipe" });
  expect(await opened(readFileSync(again, "utf8")), "recorded by the command").toEqual(EVERYWHERE);
}

it.each(Object.entries(DRAWN))(
  "%s, made flat on the page, verifies at every door",
  (name, draw) => holdEverywhere(name, draw()),
  PATIENCE,
);

it.skipIf(!NIGHTLY || !existsSync(SHARED)).each(FILES)(
  "%s, made flat on the page, verifies at every door",
  (name) => holdEverywhere(name, readFileSync(join(SHARED, name), "utf8")),
  PATIENCE,
);
