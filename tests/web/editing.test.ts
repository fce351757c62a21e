// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import {
  addHandle,
  commitSettings,
  edit,
  freePins,
  redo,
  removeHandles,
  setPinned,
  setTarget,
  shownPoint,
  undo,
} from "../../web/src/state/editing.ts";
import type { Page } from "../../web/src/state/page.ts";
import { openedPage } from "./support/page-here.ts";

/** The middle of the roof, of 21 by 21 points. */
const MIDDLE = 220;

const past = (page: Page): number => page.history.value?.past.length ?? -1;

/** Moves the middle up, model units. */
function lift(page: Page, by: number, burst: string | null = null): Promise<unknown> {
  const [x = 0, y = 0, z = 0] = page.mesh.value?.positions.slice(3 * MIDDLE, 3 * MIDDLE + 3) ?? [];
  return setTarget(page, MIDDLE, [x, y, z + by], burst);
}

it("an edit is one step of the history, and what undo and redo go between", async () => {
  const page = await openedPage();
  expect(past(page)).toBe(0);
  await lift(page, 0.2);
  const edited = page.history.value?.present;
  expect(past(page)).toBe(1);
  expect(edited?.report.status).toBe("converged");
  expect(edited?.shape.moved.includes(MIDDLE)).toBe(true);
  expect(page.draft.value).toBe(edited);
  await undo(page);
  expect(page.history.value?.present.shape.moved.length).toBe(0);
  expect(page.figures.value.movedVertices).toBe(0);
  await redo(page);
  expect(page.history.value?.present).toBe(edited);
  expect(page.figures.value).toBe(edited?.report);
});

it("keys of one burst are one step; another burst is another", async () => {
  const page = await openedPage();
  await lift(page, 0.1, "a");
  await lift(page, 0.15, "a");
  expect(past(page)).toBe(1);
  await lift(page, 0.2, "b");
  expect(past(page)).toBe(2);
  await undo(page);
  expect(page.history.value?.present.handles[0]?.target).toEqual([
    ...(page.mesh.value?.positions.slice(3 * MIDDLE, 3 * MIDDLE + 2) ?? []),
    (page.mesh.value?.positions[3 * MIDDLE + 2] ?? 0) + 0.15,
  ]);
});

it("an edit reaches as far as it has to, but as far as someone chose, also where that is furthest", async () => {
  for (const [change, reach] of [
    [{}, 3],
    [{ softness: 5, reach: 6 }, 3],
    [{ reach: 6 }, 6],
    [{ softness: 4, reach: 4 }, 4],
  ] as const) {
    const page = await openedPage();
    await commitSettings(page, change);
    await lift(page, 0.05);
    expect(page.draft.value?.settings.reach).toBe(reach);
  }
});

it("a failure keeps the last design, and says why", async () => {
  let refuse = false;
  const page = await openedPage("roof", ({ kind, job }) =>
    refuse && kind === "edit" ? { kind: "failed", job, message: "No.", fatal: false } : null,
  );
  await lift(page, 0.2);
  const kept = page.history.value?.present;
  refuse = true;
  await lift(page, 0.3);
  expect(page.problem.value).toBe("No.");
  expect(page.history.value?.present).toBe(kept);
  expect(page.draft.value).toBe(kept);
  refuse = false;
  await lift(page, 0.3);
  expect(page.problem.value).toBeNull();
  expect(past(page)).toBe(2);
});

it("a pinned point keeps its place to the last bit; freed, it is no handle any more", async () => {
  const page = await openedPage();
  const pin = MIDDLE + 1;
  await setPinned(page, [pin], true);
  await lift(page, 0.2);
  const base = [...(page.mesh.value?.positions.slice(3 * pin, 3 * pin + 3) ?? [])];
  expect(shownPoint(page, pin)).toEqual(base);
  expect(page.history.value?.present.shape.moved.includes(pin)).toBe(false);
  await freePins(page, [pin]);
  expect(page.handles.value.map(({ vertex }) => vertex)).toEqual([MIDDLE]);
  expect(shownPoint(page, pin)).not.toEqual(base);
  await removeHandles(page, [MIDDLE]);
  expect(page.handles.value).toEqual([]);
  expect(page.figures.value.movedVertices).toBe(0);
});

it("adds a sensible handle where nothing is selected, and never one twice", async () => {
  const page = await openedPage();
  await addHandle(page);
  await addHandle(page);
  const vertices = page.handles.value.map(({ vertex }) => vertex);
  expect(new Set(vertices).size).toBe(2);
});

it("a tolerance that the mesh does not meet is noted, not tried", async () => {
  const page = await openedPage();
  await lift(page, 0.2);
  const before = page.history.value;
  const worst = page.mesh.value?.report.worstExcess ?? 0;
  await commitSettings(page, { tolerance: worst / 2 - 1 });
  expect(page.refusedTolerance.value).toBe(worst / 2 - 1);
  expect(page.history.value).toBe(before);
});

it("two pages do not know of each other", async () => {
  const [one, two] = await Promise.all([openedPage(), openedPage("vault")]);
  await edit(one, () => [{ vertex: MIDDLE, target: shownPoint(one, MIDDLE), pinned: true }]);
  expect(two.handles.value).toEqual([]);
  expect(past(two)).toBe(0);
});
