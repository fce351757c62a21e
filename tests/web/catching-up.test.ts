// SPDX-License-Identifier: MIT
// A drag that was let go before panels had followed: what goes on behind it, and what ends that.
import { expect, it } from "vitest";
import { FIRST_SETTINGS, NO_REPORT } from "../../web/src/design/design.ts";
import { CATCHING_UP, catchUp, isCatchingUp } from "../../web/src/features/stopping/catching-up.ts";
import { beginDrag } from "../../web/src/state/dragging.ts";
import { undo } from "../../web/src/state/editing.ts";
import { lastLeftBehind } from "../../web/src/state/left-behind.ts";
import type { Page } from "../../web/src/state/page.ts";
import { refusedPull } from "../../web/src/state/refused-pull.ts";
import { openedPage } from "./support/page-here.ts";

const MIDDLE = 220;
const PULL = 0.3;

/** A drag up whose frames, and whose end, leave the point at a tenth of the way; `bounds` of its frames. Later
 * edits are the core's own. */
async function leftBehind(bounds: Readonly<Record<string, readonly number[]>> = {}) {
  let ended = false;
  let base = [0, 0, 0];
  const page = await openedPage("roof", (request) => {
    if (request.kind !== "edit" || ended) return null;
    ended = request.mode === "release";
    const [v = 0, x = 0, y = 0] = request.targets.handles;
    const taken = [v, x, y, (base[2] ?? 0) + PULL / 10];
    const shape = { moved: Int32Array.of(v), positions: Float64Array.from(taken.slice(1)) };
    const status = ended ? "converged" : "iteration_limit";
    const report = { ...NO_REPORT, status, bounds, movedVertices: 1 };
    const changes = new Float32Array();
    const found = ended ? ["fold=+10"] : [];
    const shown = { kind: "shown", job: request.job, changes, report, shape, found } as const;
    return { ...shown, taken: ended ? taken : null, reach: FIRST_SETTINGS.reach, placed: null };
  });
  base = [...(page.mesh.value?.positions.slice(3 * MIDDLE, 3 * MIDDLE + 3) ?? [])];
  const drag = beginDrag(page, [MIDDLE]);
  drag?.by([0, 0, PULL]);
  await expect.poll(() => page.figures.value.movedVertices).toBe(1);
  await drag?.end();
  await expect.poll(() => page.busy.value).toBe(false);
  return page;
}

const height = (page: Page): number => {
  const [row] = page.history.value?.present.handles ?? [];
  return (row?.target[2] ?? 0) - (page.mesh.value?.positions[3 * MIDDLE + 2] ?? 0);
};

it("goes on to where it was let go, in the same step of the history", async () => {
  const page = await leftBehind();
  expect(height(page)).toBeCloseTo(PULL / 10, 12);
  const going = catchUp(page);
  expect(page.notice.value).toBe(CATCHING_UP);
  expect(page.busy.value).toBe(false);
  await going;
  expect(height(page)).toBeCloseTo(PULL, 12);
  expect(page.figures.value.status).toBe("converged");
  expect(page.figures.value.movedVertices).toBeGreaterThan(1);
  expect(page.draft.value).toBe(page.history.value?.present);
  expect(refusedPull(page).value).toBeNull();
  expect(page.notice.value).toBeNull();
  expect(isCatchingUp(page)).toBe(false);
  expect(page.history.value?.past.length).toBe(1);
  await undo(page);
  expect(page.figures.value.movedVertices).toBe(0);
});

it("ends with a press, and what is there stays", async () => {
  const page = await leftBehind();
  const before = page.history.value;
  const said = page.notice.value;
  const going = catchUp(page);
  beginDrag(page, [MIDDLE + 1]);
  await going;
  expect(page.history.value).toBe(before);
  expect(page.notice.value).toBe(said);
  expect(isCatchingUp(page)).toBe(false);
  // Once a drag.
  expect(lastLeftBehind(page).value).toBeNull();
});

it("ends with Undo at once, which takes the drag back", async () => {
  const page = await leftBehind();
  const going = catchUp(page);
  await undo(page);
  await going;
  expect(page.history.value?.past.length).toBe(0);
  expect(page.figures.value.movedVertices).toBe(0);
});

it("is of drags alone that no limit held back", async () => {
  const page = await leftBehind({ fold: [3] });
  const before = page.history.value;
  await catchUp(page);
  expect(page.history.value).toBe(before);
});
