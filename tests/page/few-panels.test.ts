// SPDX-License-Identifier: MIT
// Few panels to make again: the curve of an edit, each point of it one press away, and the command line's answer.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { FIRST_SETTINGS } from "../../web/src/design/design.ts";
import { readObj } from "../browser/support/obj.ts";
import { exportAs, idle, obj, typeTarget } from "../browser/support/page.ts";
import { encodeLink } from "../web/support/links.ts";
import { site } from "./support/site.ts";

const CLI = new URL("../../build/native/planish", import.meta.url).pathname;

let folder: string;

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), "planish-few-"));
});

afterAll(() => rmSync(folder, { recursive: true }));

const DESIGN = {
  source: { kind: "sample", name: "vault", size: 11 },
  planarised: null,
  handles: [],
  settings: { ...FIRST_SETTINGS, reach: 4 },
  families: [],
  unit: "m",
  camera: null,
  mark: { hash: 0, moved: 0, probes: [] },
} as const;

/** A soft edit of a small vault. */
async function edited(): Promise<Page> {
  const page = await site.open({}, await encodeLink(DESIGN));
  await typeTarget(page, "+40cm");
  return page;
}

const part = (page: Page) => page.getByRole("region", { name: "Few panels" });

const points = (page: Page) =>
  part(page)
    .getByRole("list", { name: "Panels cut again against the sharpest fold" })
    .getByRole("button");

const point = (page: Page, name: RegExp) => part(page).getByRole("button", { name });

const slider = (page: Page) => part(page).getByRole("slider", { name: "Few panels" });

const find = (page: Page) =>
  part(page).getByRole("button", { name: "Find edits with fewer panels" }).click();

/** "Sparse: 42 panels cut again, folds up to 8° sharper" → 42 */
const panelsIn = (words: string | null): number =>
  Number(/(\d+) panels? cut again/.exec(words ?? "")?.[1] ?? Number.NaN);

const price = async (page: Page): Promise<number> =>
  panelsIn(
    await part(page)
      .getByText(/^\d+ panels? cut again, folds up to/)
      .textContent(),
  );

interface Written {
  readonly source: { readonly sample: string; readonly size: number };
  readonly handles: readonly (readonly number[])[];
  readonly pins: readonly number[];
  readonly options: { readonly bounds: readonly string[]; readonly attraction: number };
}

const written = async (page: Page): Promise<Written> =>
  JSON.parse((await exportAs(page, "JSON")).toString());

it("computes the curve of the edit, and what is taken from it is the command line's edit", async () => {
  const page = await edited();
  const [soft, before] = [await written(page), await obj(page)];
  const gentle = await price(page);
  expect(await slider(page).count()).toBe(0);
  await find(page);
  await point(page, /^Fewest, folds up to 15° sharper:/).waitFor();
  await part(page).getByRole("button", { name: "Stop" }).click();
  const names = await Promise.all(
    (await points(page).all()).map((one) => one.getAttribute("aria-label")),
  );
  expect(panelsIn(names[0] ?? "")).toBe(gentle);
  // Those alone that no other betters: each has fewer panels than the gentler ones before it.
  const drawn = names.map((name) => panelsIn(name ?? ""));
  expect(drawn.length).toBeGreaterThanOrEqual(2);
  expect(drawn).toEqual([...new Set(drawn)].sort((a, b) => b - a));
  expect(await obj(page)).toBe(before); // nothing has changed yet

  await point(page, /^Fewest, folds up to 15° sharper:/).click();
  await idle(page);
  const few = await written(page);
  expect(await price(page)).toBeLessThan(0.5 * gentle);
  expect(few.pins.length).toBeGreaterThan(10);
  expect(few.handles).toEqual(soft.handles);
  expect(few.options.bounds).toContain("fold=+15");
  const { sample, size } = soft.source;
  const [vertex, ...target] = soft.handles[0] ?? [];
  const options =
    "--softness 5 --reach 4 --keep-boundary --bound fold=+15 --fewest panels -o few.obj --design few.json --report r.json";
  const given = ["--handle", `${vertex}=${target.join()}`, ...options.split(" ")];
  execFileSync(CLI, ["edit", `sample:${sample}:${size}`, ...given], { cwd: folder });
  const command = JSON.parse(readFileSync(join(folder, "few.json"), "utf8"));
  expect(few.pins).toEqual(command.pins);
  expect(few.options.bounds).toEqual(command.options.bounds);
  expect(few.options.attraction).toBe(command.options.attraction);
  const report = JSON.parse(readFileSync(join(folder, "r.json"), "utf8"));
  expect(await price(page)).toBe(report.fewest.panels);
  const [here, there] = [
    readObj(await obj(page)),
    readObj(readFileSync(join(folder, "few.obj"), "utf8")),
  ];
  for (const [k, p] of here.points.entries())
    for (const axis of [0, 1, 2] as const)
      expect(Math.abs((p[axis] ?? 0) - (there.points[k]?.[axis] ?? Number.NaN))).toBeLessThan(1e-8);
  // The page's own file replays to the bit.
  writeFileSync(join(folder, "page.json"), await exportAs(page, "JSON"));
  execFileSync(CLI, ["replay", "page.json", "-o", "page.obj"], { cwd: folder });

  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  expect(await obj(page)).toBe(before);
  expect(await price(page)).toBe(gentle);
  // The curve is that of this edit still; its last end has the fewest panels.
  await slider(page).press("End");
  await idle(page);
  await expect.poll(() => price(page)).toBe(Math.min(...names.map((name) => panelsIn(name))));
  await page.context().close();
});

it("can be stopped, keeps what it has, and is let go where the edit is another", async () => {
  const page = await edited();
  await find(page);
  await point(page, /^Sparse:/).waitFor();
  await part(page).getByRole("button", { name: "Stop" }).click();
  expect(await part(page).getByRole("button", { name: "Stop" }).count()).toBe(0);
  expect(await points(page).count()).toBeGreaterThan(1);
  await typeTarget(page, "+30cm");
  await idle(page);
  expect(await points(page).count()).toBe(0);
  await part(page).getByRole("button", { name: "Find edits with fewer panels" }).waitFor();
  await page.context().close();
});

it("stops at a number of panels, which folds more gently than the fewest do", async () => {
  const page = await edited();
  const gentle = await price(page);
  const most = Math.round(0.6 * gentle);
  await part(page).getByRole("spinbutton", { name: "At most" }).fill(String(most));
  await find(page);
  await point(page, new RegExp(`^At most ${most} panels:`)).click();
  await idle(page);
  const panels = await price(page);
  expect(panels).toBeLessThanOrEqual(most);
  expect(panels).toBeGreaterThan(0.5 * most);
  expect((await written(page)).pins.length).toBeGreaterThan(0);
  await page.context().close();
});
