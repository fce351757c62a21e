// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { clearOfPoint, OFFER } from "../../web/src/features/touch/clear-of-point.ts";
import { beginDrag } from "../../web/src/state/dragging.ts";
import { setTarget, shownPoint } from "../../web/src/state/editing.ts";
import {
  discardDrag,
  fingerDrag,
  keepDrag,
  offerToTakeBack,
} from "../../web/src/state/finger-drag.ts";
import type { Page } from "../../web/src/state/page.ts";
import { openedPage } from "./support/page-here.ts";

const MIDDLE = 220;

/** A finger drags the middle up, and is lifted. */
async function dragged(page: Page, up: number): Promise<void> {
  const drag = beginDrag(page, [MIDDLE]);
  drag?.by([0, 0, up]);
  await offerToTakeBack(page, MIDDLE, drag?.end() ?? Promise.resolve(undefined));
}

const steps = (page: Page): number => page.history.value?.past.length ?? 0;

it("a drag by a finger is taken back as one step, which can be done again", async () => {
  const page = await openedPage();
  const before = page.history.value?.present;
  await dragged(page, 0.2);
  expect([fingerDrag(page).value?.vertex, steps(page)]).toEqual([MIDDLE, 1]);
  await discardDrag(page);
  expect(fingerDrag(page).value).toBeNull();
  expect(page.history.value?.present).toBe(before);
  expect(page.canRedo.value).toBe(true);
  // There is nothing more to take back.
  await discardDrag(page);
  expect(page.history.value?.present).toBe(before);
});

it("one that is kept is offered no longer", async () => {
  const page = await openedPage();
  await dragged(page, 0.2);
  keepDrag(page);
  expect(fingerDrag(page).value).toBeNull();
  await discardDrag(page);
  expect(steps(page)).toBe(1);
});

it("another drag or step ends the offer; only the last one is taken back", async () => {
  const page = await openedPage();
  await dragged(page, 0.2);
  const first = page.history.value?.present;
  const drag = beginDrag(page, [MIDDLE]);
  drag?.by([0, 0, 0.1]);
  expect(fingerDrag(page).value).toBeNull();
  await drag?.abandon();
  expect(fingerDrag(page).value).toBeNull();
  await dragged(page, 0.1);
  await discardDrag(page);
  expect(page.history.value?.present).toBe(first);
  await dragged(page, 0.1);
  const [x, y, z] = shownPoint(page, MIDDLE);
  const typed = setTarget(page, MIDDLE, [x, y, z + 0.05]);
  await discardDrag(page);
  await typed;
  expect([fingerDrag(page).value, steps(page)]).toEqual([null, 3]);
});

it("nothing is offered where nothing moved, or the drag was given up", async () => {
  const page = await openedPage();
  await offerToTakeBack(
    page,
    MIDDLE,
    beginDrag(page, [MIDDLE])?.end() ?? Promise.resolve(undefined),
  );
  expect(fingerDrag(page).value).toBeNull();
  await offerToTakeBack(page, MIDDLE, Promise.resolve({ ok: false, reason: "No." }));
  expect(fingerDrag(page).value).toBeNull();
});

it("what is offered lies inside the view, clear of the point and of the tools, wherever that is", () => {
  const view = { width: 390, height: 430 };
  for (let x = 0; x <= view.width; x += 13)
    for (let y = 60; y <= 400; y += 10) {
      const at = clearOfPoint({ x, y }, OFFER, view);
      expect(at.x).toBeGreaterThanOrEqual(0);
      expect(at.x + OFFER.width).toBeLessThanOrEqual(view.width);
      expect(at.y).toBeGreaterThanOrEqual(52);
      expect(at.y + OFFER.height).toBeLessThanOrEqual(view.height);
      // With the bump that it raised.
      expect(at.y - y >= 72 || y - (at.y + OFFER.height) >= 72).toBe(true);
    }
});
