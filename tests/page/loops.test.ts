// SPDX-License-Identifier: MIT
// A loop drawn by hand selects the points that it goes round; with a mouse, with keys held, by a finger.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { movedCount } from "../browser/support/page.ts";
import { hintedPoint, type Place, press } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

const ROOMY = { viewport: { width: 1440, height: 900 } };

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

it("selects what it goes round, and not what lies in its bay; the tool is let go", async () => {
  const page = await site.openVault({ ...ROOMY, size: 21 });
  const at = await hintedPoint(page);
  await tool(page).click();
  expect(await tool(page).getAttribute("aria-pressed")).toBe("true");
  const [first = at, ...rest] = around(at, 90);
  await press(page, first, ...rest);
  expect(await page.locator(".selection-area").isVisible()).toBe(true);
  await page.mouse.up();
  expect(await page.locator(".selection-area").isVisible()).toBe(false);
  expect(await tool(page).getAttribute("aria-pressed")).toBe("false");
  await expect.poll(async () => (await marked(page)).length).toBeGreaterThan(8);
  await expect.poll(() => astray(page, at, 90)).toBe(0);
  const inLoop = await marked(page);
  expect(await movedCount(page)).toBe(0);

  // A box of the same size holds what lies in the bay, too.
  await page.getByRole("button", { name: "Select in a box" }).click();
  await press(page, { x: at.x - 90, y: at.y - 90 }, { x: at.x + 90, y: at.y + 90 });
  await page.mouse.up();
  await expect.poll(async () => (await marked(page)).length).toBeGreaterThan(inLoop.length);
  // Points at the line of the bay may be on either side of it.
  await expect.poll(() => astray(page, at, 90)).toBeGreaterThan(8);
  expect(await astray(page, at, 90)).toBeLessThanOrEqual(
    (await marked(page)).length - inLoop.length,
  );
  await page.context().close();
});

it("with Shift and Alt a drag draws one at once, and adds what it holds", async () => {
  const page = await site.openVault({ ...ROOMY, size: 21 });
  const at = await hintedPoint(page);
  await page.mouse.click(at.x, at.y);
  await expect.poll(async () => (await marked(page)).length).toBe(1);
  await page.keyboard.down("Shift");
  await page.keyboard.down("Alt");
  const [first = at, ...rest] = around(at, 70);
  await press(page, first, ...rest);
  await page.mouse.up();
  await page.keyboard.up("Alt");
  await page.keyboard.up("Shift");
  await expect.poll(async () => (await marked(page)).length).toBeGreaterThan(5);
  // The point that was selected lies in the bay.
  await expect.poll(() => astray(page, at, 70)).toBe(1);
  await page.context().close();
});

it("Escape gives it up", async () => {
  const page = await site.openVault({ ...ROOMY, size: 21 });
  const at = await hintedPoint(page);
  await tool(page).click();
  const [first = at, ...rest] = around(at, 70);
  await press(page, first, ...rest.slice(0, 4));
  await page.keyboard.press("Escape");
  expect(await page.locator(".selection-area").isVisible()).toBe(false);
  await page.mouse.up();
  expect(await tool(page).getAttribute("aria-pressed")).toBe("false");
  expect(await marked(page)).toEqual([]);
  await page.context().close();
});
