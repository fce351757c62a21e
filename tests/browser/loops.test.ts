// SPDX-License-Identifier: MIT
// Needs: pointer.
// A loop drawn by hand selects the points that it goes round; with a mouse, with keys held, by a finger.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { movedCount } from "./support/page.ts";
import { openPhone } from "./support/touch.ts";
import { hintedPoint, type Place, viewBox } from "./support/view.ts";

const tool = (page: Page) => page.getByRole("button", { name: "Select in a loop" });

/** Where the selected points are on screen. */
const marked = (page: Page): Promise<Place[]> =>
  page.locator(".marker.selected:not([hidden])").evaluateAll((all) =>
    all.map((mark) => {
      const { x, y, width, height } = mark.getBoundingClientRect();
      return { x: x + width / 2, y: y + height / 2 };
    }),
  );

/** A U of this size around a place, which lies in its bay. */
const around = ({ x, y }: Place, size: number): Place[] =>
  [
    [-size, -size],
    [-size / 4, -size],
    [-size / 4, size / 3],
    [size / 4, size / 3],
    [size / 4, -size],
    [size, -size],
    [size, size],
    [-size, size],
  ].map(([dx = 0, dy = 0]) => ({ x: x + dx, y: y + dy }));

/** How many selected points the U around a place does not hold, once their marks are drawn. */
const astray = async (page: Page, at: Place, size: number): Promise<number> =>
  (await marked(page)).filter((place) => !holds(at, size, place)).length;

/** Whether the U goes round a place; pixels at its line may go either way. */
function holds(at: Place, size: number, { x, y }: Place): boolean {
  const [dx, dy] = [Math.abs(x - at.x), y - at.y];
  return dx < size + 1 && Math.abs(dy) < size + 1 && !(dx < size / 4 - 1 && dy < size / 3 - 1);
}

it("a finger draws one where the tool is chosen", async () => {
  const { page, touch } = await openPhone();
  const first = await hintedPoint(page);
  await touch("touchStart", [first]);
  await touch("touchEnd", []);
  await tool(page).tap();
  // Clear of the tools at the top of the view.
  const { x, y, width, height } = await viewBox(page);
  const at = { x: x + width / 2, y: y + height / 2 };
  const loop = around(at, 60);
  await touch("touchStart", loop.slice(0, 1));
  for (const place of [...loop.slice(1), ...loop.slice(0, 1)]) await touch("touchMove", [place]);
  await expect.poll(() => page.locator(".selection-area").isVisible()).toBe(true);
  await touch("touchEnd", []);
  await expect.poll(async () => (await marked(page)).length).toBeGreaterThan(3);
  await expect.poll(() => astray(page, at, 60)).toBe(0);
  expect(await movedCount(page)).toBe(0);
  await page.context().close();
});
