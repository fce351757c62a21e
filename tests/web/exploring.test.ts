// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { begin } from "../../web/src/design/history.ts";
import { recipeOf } from "../../web/src/design/recipe.ts";
import { commitVariation, explore, makeExact } from "../../web/src/features/exploring/exploring.ts";
import { furthestBetween, reachOf } from "../../web/src/features/exploring/furthest.ts";
import { fillGallery, gallery } from "../../web/src/features/exploring/gallery.ts";
import { commitSettings, setTarget, shownPoint, undo } from "../../web/src/state/editing.ts";
import { markOf } from "../../web/src/state/marking.ts";
import type { Page } from "../../web/src/state/page.ts";
import { replay } from "../../web/src/state/replaying.ts";
import { show } from "../../web/src/state/showing.ts";
import { openedPage, pageHere } from "./support/page-here.ts";

const MIDDLE = 220;

async function exploredPage(): Promise<Page> {
  const page = await openedPage();
  const [x, y, z] = shownPoint(page, MIDDLE);
  await setTarget(page, MIDDLE, [x, y, z + 0.2]);
  await explore(page);
  return page;
}

it("finds as many directions as were asked for, as one step of the history", async () => {
  const page = await exploredPage();
  const { variation } = page.history.value?.present ?? {};
  expect(variation?.coefficients).toEqual([0, 0, 0, 0]);
  expect(variation?.exact).toBe(true);
  expect(page.history.value?.past.length).toBe(2);
});

it("a slider ends exact, and undo goes back to the edit that it varies", async () => {
  const page = await exploredPage();
  const edited = page.history.value?.present;
  await commitVariation(page, 1, 0.3);
  const varied = page.history.value?.present;
  expect(varied?.variation?.coefficients).toEqual([0, 0.3, 0, 0]);
  expect(varied?.variation?.exact).toBe(true);
  expect(varied?.report.worstExcess).toBeLessThanOrEqual(1e-6);
  await undo(page);
  expect(page.history.value?.present).toBe(edited);
  // The solver has to find its directions again, the same ones.
  await commitVariation(page, 1, 0.3);
  expect(page.history.value?.present.shape.positions).toEqual(varied?.shape.positions);
});

it("a slider goes on from a design that another solver has only been told", async () => {
  const page = await exploredPage();
  await commitVariation(page, 1, 0.3);
  const varied = page.history.value?.present;
  if (!varied) throw new Error("no design");
  // Its solver begins as every first one does, without knowing variations.
  const other = await openedPage();
  expect(await show(other, varied)).toMatchObject({ ok: true });
  other.history.value = begin(varied);
  for (const one of [page, other]) await commitVariation(one, 0, -0.2);
  const [here, there] = [page, other].map((one) => one.history.value?.present);
  expect(here?.variation?.coefficients).toEqual([-0.2, 0.3, 0, 0]);
  expect(there?.variation?.coefficients).toEqual([-0.2, 0.3, 0, 0]);
  expect(there?.shape).toEqual(here?.shape);
});

it("makes exact what is exact already without another step", async () => {
  const page = await openedPage();
  await makeExact(page);
  expect(page.history.value?.past.length).toBe(0);
});

it("fills a gallery of flat designs, and only around the variation that is shown", async () => {
  const page = await exploredPage();
  await fillGallery(page);
  const items = gallery(page).value?.items ?? [];
  expect(items.length).toBeGreaterThan(0);
  expect(gallery(page).value?.planned).toBe(items.length);
  for (const { report } of items) expect(report.worstExcess).toBeLessThanOrEqual(1e-6);
});

it("where limits hold variations back, its designs still differ to the eye, and those left out are counted", async () => {
  const page = await openedPage();
  const [x, y, z] = shownPoint(page, MIDDLE);
  await setTarget(page, MIDDLE, [x, y, z + 0.2]);
  await commitSettings(page, { limits: ["slide=0.2"] });
  await explore(page);
  await fillGallery(page);
  const { centre, items = [], alike = 0 } = gallery(page).value ?? {};
  const base = page.mesh.value?.positions;
  if (!centre || !base) throw new Error("no gallery");
  expect(items.length).toBeGreaterThan(0);
  expect(alike).toBeGreaterThan(0);
  const shapes = [centre, ...items.map(({ shape }) => shape)];
  shapes.forEach((shape, k) => {
    for (const other of shapes.slice(0, k)) {
      const { move = [0, 0, 0] } = furthestBetween(other, shape, base) ?? {};
      expect(Math.hypot(...move)).toBeGreaterThan(0.01 * reachOf(centre, base));
    }
  });
});

it("its recipe replayed by another page gives the same bits, and is verified", async () => {
  const page = await exploredPage();
  await commitVariation(page, 0, 0.25);
  const design = page.history.value?.present;
  const mark = design && (await markOf(page, design.shape));
  if (!design || !mark) throw new Error("no design");
  const other = pageHere();
  expect(await replay(other, recipeOf(design, "mm", null, mark))).toBe(true);
  const again = other.history.value?.present;
  expect(again?.shape).toEqual(design.shape);
  expect(other.unit.value).toBe("mm");
  expect(other.problem.value).toBeNull();
  expect(other.notice.value).toMatch(/^Verified/);
});

it("a recipe with another result is opened, and the deviation said", async () => {
  const page = await exploredPage();
  const design = page.history.value?.present;
  const mark = design && (await markOf(page, design.shape));
  if (!design || !mark) throw new Error("no design");
  const other = pageHere();
  const lifted = design.handles.map((row) => ({
    ...row,
    target: [row.target[0], row.target[1], row.target[2] + 0.05] as const,
  }));
  const recipe = { ...recipeOf(design, "mm", null, mark), handles: lifted };
  expect(await replay(other, recipe)).toBe(true);
  expect(other.notice.value).toBeNull();
  expect(other.problem.value).toMatch(/differs/);
});

it("a recipe of a mesh that is none leaves what was there", async () => {
  const page = await exploredPage();
  const before = page.history.value?.present;
  const mark = before && (await markOf(page, before.shape));
  if (!before || !mark) throw new Error("no design");
  const source = { kind: "sample", name: "no such mesh", size: 4 } as const;
  expect(await replay(page, { ...recipeOf(before, "mm", null, mark), source })).toBe(false);
  expect(page.history.value?.present).toBe(before);
  expect(page.problem.value).not.toBeNull();
});
