// SPDX-License-Identifier: MIT
// A mesh that is not flat, made flat and edited at one door, opens and verifies at every other.
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
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

/** What is asked for at the door of a mesh, and what its panels are then. */
interface Way {
  readonly label: string;
  readonly ask: (page: Page) => Promise<unknown>;
  /** The button that edits begin with. */
  readonly begin: "Start editing" | "Edit as it is";
  readonly worst: RegExp;
}

const FLAT: Way = {
  label: "flat",
  ask: async () => undefined,
  begin: "Start editing",
  worst: / flat/,
};

const toWithin20 = (page: Page) =>
  page.getByRole("combobox", { name: "Flat", exact: true }).selectOption("to within 20 mm/m");

/** The first trial lets the boundary move where that is what it takes: before it ends, a box may change by itself. */
const firstTried = (page: Page) =>
  expect
    .poll(
      async () => {
        const drawn = await page.getByRole("button", { name: "Before: the file" }).count();
        return drawn > 0 && (await page.getByRole("button", { name: "Stop trying" }).count()) === 0;
      },
      { timeout: PATIENCE },
    )
    .toBe(true);

const NEARLY_FLAT: Way = {
  label: "flat to within 20 mm/m",
  ask: async (page) => {
    await firstTried(page);
    await page.getByRole("checkbox", { name: "Keep the boundary where it is" }).uncheck();
    await toWithin20(page);
  },
  begin: "Start editing",
  worst: /\((1\d(\.\d)?|20) mm\/m\)/,
};

const NEAR_THE_FILE: Way = {
  label: "as flat as points get by 200 mm",
  ask: async (page) => {
    await firstTried(page);
    await toWithin20(page);
    const most = page.getByRole("textbox", { name: "Largest move" });
    await most.fill("200mm");
    await most.press("Enter");
  },
  begin: "Edit as it is",
  worst: /\([2-9]\d(\.\d)? mm\/m\)/,
};

/** The design that the page saves once the mesh was made so and a point of it raised. */
async function madeOnThePage(name: string, mesh: string, way: Way): Promise<string> {
  const page = await site.open();
  await openFile(page, name, mesh);
  await way.ask(page);
  await page.getByRole("button", { name: "Planarise", exact: true }).click();
  await expect.poll(() => status(page), { timeout: PATIENCE }).toContain("planarised first");
  await page.getByRole("button", { name: way.begin }).click();
  await idle(page);
  await typeTarget(page, "+10cm");
  await idle(page);
  expect(await status(page)).toMatch(/[1-9]\d* of \d+ points move /);
  expect(await status(page)).toMatch(way.worst);
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
async function holdEverywhere(name: string, mesh: string, way = FLAT): Promise<void> {
  const made = await madeOnThePage(name, mesh, way);
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

/** Along its straight lines: no flat mesh is near. */
const saddle = (): string => quads(8, (x, y) => 8 * x * y);

const bowl = (): string => quads(8, (x, y) => 6 * (x * x + y * y) + 4 * x * y);

it.each([
  { name: "a bowl", way: NEARLY_FLAT, draw: bowl },
  { name: "a saddle", way: NEAR_THE_FILE, draw: saddle },
])(
  "$name, made $way.label on the page, verifies at every door",
  ({ way, draw }) => holdEverywhere("drawn.obj", draw(), way),
  PATIENCE,
);

const real = (name: string): string => readFileSync(join(SHARED, name), "utf8");

const AT_NIGHT = it.skipIf(!NIGHTLY || !existsSync(SHARED));

AT_NIGHT.each(FILES)(
  "%s, made flat on the page, verifies at every door",
  (name) => holdEverywhere(name, real(name)),
  PATIENCE,
);

AT_NIGHT.each([NEARLY_FLAT, NEAR_THE_FILE])(
  "quad_pillow.obj, made $label on the page, verifies at every door",
  (way) => holdEverywhere("quad_pillow.obj", real("quad_pillow.obj"), way),
  PATIENCE,
);
