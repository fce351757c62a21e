// SPDX-License-Identifier: MIT
// What the solver is asked for while designs are compared.
import { expect, it } from "vitest";
import {
  chooseFirst,
  comparedFigures,
  followCompared,
} from "../../web/src/features/comparing/comparing.ts";
import { commitVariation, explore } from "../../web/src/features/exploring/exploring.ts";
import { setTarget, shownPoint } from "../../web/src/state/editing.ts";
import { openFile } from "../../web/src/state/files.ts";
import type { Page } from "../../web/src/state/page.ts";
import { lastRefusedPull } from "../../web/src/state/refused-pull.ts";
import { largestShortfall } from "../../web/src/state/shortfall.ts";
import { takeSnapshot } from "../../web/src/state/snapshots.ts";
import { openedPage, pageHere } from "./support/page-here.ts";

const MIDDLE = 220;

/** What is counted is not looked at here. */
const TWO_TYPES = {
  problem: "",
  ofPanel: new Int32Array(0),
  sizes: Int32Array.of(300, 100),
  worstFit: 0,
  within: 0,
};

/** With two designs kept beside the one shown; `asked` has the kinds of all questions since. */
async function threeDesigns(): Promise<{ readonly page: Page; readonly asked: string[] }> {
  const asked: string[] = [];
  const page = await openedPage("roof", ({ kind, job }) => {
    asked.push(kind);
    return kind === "types" ? { kind, job, types: TWO_TYPES } : null;
  });
  const [x, y, z] = shownPoint(page, MIDDLE);
  for (const up of [0.1, 0.2]) {
    await setTarget(page, MIDDLE, [x, y, z + up]);
    await takeSnapshot(page);
  }
  await setTarget(page, MIDDLE, [x, y, z + 0.3]);
  chooseFirst(page);
  asked.splice(0);
  return { page, asked };
}

const count = (asked: readonly string[], kind: string): number =>
  asked.filter((one) => one === kind).length;

const counted = (page: Page): number =>
  [...comparedFigures(page).value.values()].filter(({ types }) => types).length;

const later = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 100));

it("each design is measured once and its types are counted once, the mesh's once for all", async () => {
  const { page, asked } = await threeDesigns();
  const stop = followCompared(page);
  await expect.poll(() => counted(page), { timeout: 20_000 }).toBe(3);
  await later();
  expect(count(asked, "measure")).toBe(3);
  expect(count(asked, "types")).toBe(4);
  stop();
});

it("the largest panel has its area in square metres, whatever way it faces", async () => {
  const page = pageHere();
  const ROOF = "v 0 0 0\nv 2 0 1\nv 2 3 1\nv 0 3 0\nv 3 0 1\nv 3 3 1\nf 1 2 3 4\nf 2 5 6 3\n";
  await openFile(page, new File([ROOF], "eaves.obj"));
  page.unit.value = "cm";
  await takeSnapshot(page);
  await takeSnapshot(page);
  chooseFirst(page);
  const stop = followCompared(page);
  await expect.poll(() => comparedFigures(page).value.size).toBe(2);
  for (const { area } of comparedFigures(page).value.values())
    expect(area).toBeCloseTo((3 * Math.hypot(2, 1)) / 100 ** 2, 8);
  stop();
});

it("nothing more is asked once the dialog is closed", async () => {
  const { page, asked } = await threeDesigns();
  const stop = followCompared(page);
  const measured = new Promise<void>((resolve) => {
    comparedFigures(page).subscribe(({ size }) => {
      if (size === 1) resolve();
    });
  });
  await measured;
  stop();
  await later();
  expect(count(asked, "measure")).toBeLessThan(3);
  expect(count(asked, "types")).toBe(0);
});

it("a handle is as far from its target as from where it was pulled, also where a limit refused that", async () => {
  const page = await openedPage();
  const [x, y, z] = shownPoint(page, MIDDLE);
  await setTarget(page, MIDDLE, [x, y, z + 0.2]);
  const design = page.history.value?.present;
  if (!design) throw new Error("no design");
  expect(largestShortfall(page, design)).toBeLessThan(0.01);
  const handles = design.handles.map((row) => ({ ...row, target: [x, y, z + 1.2] as const }));
  lastRefusedPull(page).value = { handles, growth: 10, dragged: true, design };
  const short = largestShortfall(page, design) ?? 0;
  expect(Math.abs(short - 1)).toBeLessThan(0.01);
});

it("a variation, which leaves its targets, is short of none", async () => {
  const page = await openedPage();
  const [x, y, z] = shownPoint(page, MIDDLE);
  await setTarget(page, MIDDLE, [x, y, z + 0.2]);
  await explore(page);
  await commitVariation(page, 1, 0.3);
  const design = page.history.value?.present;
  expect(design && largestShortfall(page, design)).toBeNull();
});
