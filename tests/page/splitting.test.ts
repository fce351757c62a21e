// SPDX-License-Identifier: MIT
// Panels split for what a solve asks: where a handle stops short, and where a mesh cannot be made flat. What
// it costs is shown before it is taken; taken, it is one step of the history.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { DEFAULT_SETTINGS } from "../../web/src/design/design.ts";
import type { EditSettings } from "../../web/src/solver/protocol.ts";
import { flatRoof } from "../browser/support/faults.ts";
import { readObj } from "../browser/support/obj.ts";
import { idle, movedCount, obj, openFile, typeTarget } from "../browser/support/page.ts";
import { encodeLink } from "../web/support/links.ts";
import { cutsOf, listed, panels, start } from "./support/cutting.ts";
import { site } from "./support/site.ts";

const ROOMY = { viewport: { width: 1440, height: 900 } };

const VERTEX = 26;
const BASE_Z = 1.4746156846004828;
const PULL = 0.5;

const SETTINGS: EditSettings = {
  ...DEFAULT_SETTINGS,
  attraction: 10_000,
  softness: 3,
  reach: 2,
  keepBoundary: true,
  limits: ["fold=+12"],
};

/** Beside a boundary that stays, where folds may sharpen by 12° at most. */
const stopped = (pull: number, settings: Partial<EditSettings> = {}): Promise<string> =>
  encodeLink({
    source: { kind: "sample", name: "vault", size: 12 },
    planarised: null,
    handles: [{ vertex: VERTEX, target: [2, 2, BASE_Z + pull], pinned: false }],
    settings: { ...SETTINGS, ...settings },
    families: [],
    unit: "m",
    camera: null,
    mark: { hash: 0, moved: 0, probes: [] },
  });

const STOPPED = await stopped(PULL);

/** Further than two lines let it go. */
const FAR = await stopped(2 * PULL);

const press = async (page: Page, name: string): Promise<void> => {
  await page.getByRole("button", { name, exact: true }).click();
  await idle(page);
};

const note = (page: Page) => page.getByRole("region", { name: "Why the target is not reached" });

/** Metres from its target. */
async function short(page: Page): Promise<number> {
  const at = readObj(await obj(page)).points[VERTEX] ?? [];
  return Math.hypot((at[0] ?? 0) - 2, (at[1] ?? 0) - 2, (at[2] ?? 0) - BASE_Z - PULL);
}

it("a handle that stops gets further where panels are split: two presses, one step back", async () => {
  const page = await site.open(ROOMY, STOPPED);
  await note(page).waitFor();
  await idle(page);
  const [before, from] = [await obj(page), await short(page)];
  expect(from).toBeGreaterThan(0.3 * PULL);

  await press(page, "Split where needed");
  const curve = note(page).getByRole("table");
  await note(page).getByRole("button", { name: "Split by 1 line" }).waitFor();
  // Nothing has changed yet.
  expect(await obj(page)).toBe(before);
  const cells = await curve.locator("tbody").getByRole("cell").allTextContents();
  const column = (k: number): string[] => cells.filter((_, place) => place % 4 === k);
  const millimetres = column(0).map((words) => Number.parseFloat(words));
  expect(millimetres.length).toBeGreaterThanOrEqual(2);
  expect(Math.abs((millimetres[0] ?? 0) - 1000 * from)).toBeLessThanOrEqual(0.51);
  expect(millimetres).toEqual([...millimetres].sort((a, b) => b - a));
  for (const words of column(1)) expect(words).toMatch(/^\d+$/);
  for (const words of column(2)) expect(words).toMatch(/^\d+°$/);

  await press(page, "Split by 1 line");
  expect(Math.abs(1000 * (await short(page)) - (millimetres[1] ?? 0))).toBeLessThanOrEqual(0.51);
  expect(await panels(page)).toBe(122);
  const cuts = await cutsOf(page);
  expect(cuts).toHaveLength(1);
  expect(cuts[0]).toMatch(/^split=\d+:\d+,\d+$/);
  await start(page);
  expect(await listed(page)).toHaveLength(1);
  await page.getByLabel("3D view").press("Escape");

  await press(page, "Undo");
  expect(await obj(page)).toBe(before);
  await note(page).waitFor();
  await page.context().close();
});

it("a search for lines can be stopped, and ends with the design that it is for", async () => {
  const page = await site.open(ROOMY, STOPPED);
  await note(page).waitFor();
  await idle(page);
  await page.getByRole("button", { name: "Split where needed" }).click();
  // What the design has is in the table before any edit is solved.
  const cells = note(page).getByRole("table").locator("tbody").getByRole("cell");
  expect(Number.parseFloat((await cells.first().textContent()) ?? "")).toBeGreaterThan(300 * PULL);
  await page.getByRole("button", { name: "Stop trying" }).click();
  await page.getByRole("button", { name: "Split where needed" }).waitFor();
  expect(await note(page).getByRole("table").count()).toBe(0);
  await page.getByRole("button", { name: "Split where needed" }).click();
  await typeTarget(page, "+10cm");
  expect(await page.getByText("Trying lines through panels").count()).toBe(0);
  expect(await cutsOf(page)).toEqual([]);
  await page.context().close();
});

it("of a longer table any row can be taken", async () => {
  const page = await site.open(ROOMY, FAR);
  await note(page).waitFor();
  await idle(page);
  await page.getByRole("button", { name: "Split where needed" }).click();
  await note(page).getByRole("button", { name: "Split by 2 lines" }).waitFor();
  const rows = note(page).getByRole("table").locator("tbody").getByRole("row");
  expect(await rows.count()).toBeGreaterThanOrEqual(3);
  await press(page, "Split by 2 lines");
  expect(await cutsOf(page)).toHaveLength(2);
  expect(await panels(page)).toBe(123);
  await page.context().close();
});

it("a line is cut with its images, which it does not count", async () => {
  const page = await site.open(ROOMY, await stopped(PULL, { symmetry: ["x"] }));
  await note(page).waitFor();
  await idle(page);
  await page.getByRole("button", { name: "Split where needed" }).click();
  await note(page).getByRole("button", { name: "Split by 1 line" }).waitFor();
  await press(page, "Split by 1 line");
  expect(await cutsOf(page)).toHaveLength(2);
  expect(await panels(page)).toBe(123);
  await page.context().close();
});

it("lines are looked for where a keep-out stops a handle, and keep it", async () => {
  const top = BASE_Z + 0.3;
  const page = await site.open(ROOMY, await stopped(PULL, { keepOuts: [`above=${top}`] }));
  await note(page).waitFor();
  await idle(page);
  await page.getByText(/Keep-outs allow/).waitFor();
  await page.getByRole("button", { name: "Split where needed" }).click();
  await note(page).getByRole("button", { name: "Split by 1 line" }).waitFor();
  await press(page, "Split by 1 line");
  expect(await cutsOf(page)).toHaveLength(1);
  const { points } = readObj(await obj(page));
  expect(points[VERTEX]?.[2]).toBeLessThanOrEqual(top + 1e-9);
  await page.context().close();
});

const figures = (page: Page) => page.getByRole("table", { name: "Before and after planarising" });

const after = (page: Page, row: string) =>
  figures(page).getByRole("row", { name: row }).getByRole("cell").nth(1).textContent();

it("a mesh that cannot be flat where points stay near is, with a panel split", async () => {
  const page = await site.openVault(ROOMY);
  const lifted = flatRoof(6).replace(/^v .*$/m, "v 0 0 0.3");
  await openFile(page, "roof.obj", lifted);
  await figures(page).waitFor();
  // Where points may move as far as they have to, no panel need be split.
  await expect.poll(() => after(page, "Worst panel")).toBe("flat");
  const split = page.getByRole("combobox", { name: "Split panels" });
  expect(await split.count()).toBe(0);
  await page.getByRole("checkbox", { name: "Keep the boundary where it is" }).check();
  const most = page.getByRole("textbox", { name: "Largest move" });
  await most.fill("10mm");
  await most.press("Enter");
  await page.getByText(/no point may move farther/).waitFor();
  await split.selectOption("at most 5 %");
  await expect.poll(() => after(page, "Panels split")).toBe("1 of 36");
  expect(await after(page, "Worst panel")).toBe("flat");
  expect(await after(page, "Points that move")).toBe("0 of 49");
  await page.getByRole("button", { name: "Planarise", exact: true }).click();
  await idle(page);
  await page.getByText("1 panel split, and every panel is flat.").waitFor();
  const made = readObj(await obj(page));
  expect(made.faces).toHaveLength(37);
  expect(made.points).toEqual(readObj(lifted).points);
  await press(page, "Undo");
  expect(readObj(await obj(page)).faces).toHaveLength(36);
  await press(page, "Redo");
  expect(await panels(page)).toBe(37);
  await typeTarget(page, "+10cm");
  expect(await movedCount(page)).toBeGreaterThan(0);
  await page.context().close();
});
