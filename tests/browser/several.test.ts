// SPDX-License-Identifier: MIT
// Needs: layout.
// Several points are one thing: lines and borders are selected at once, moved, pinned and let go.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { site } from "./support/site.ts";
import { hintedPoint, type Place, viewBox } from "./support/view.ts";

const strip = (page: Page) => page.getByRole("toolbar", { name: "Selected points" });

const selected = async (page: Page): Promise<number> =>
  (await strip(page).count()) === 0
    ? 0
    : Number.parseInt((await strip(page).textContent()) ?? "", 10);

const expectSelected = (page: Page, count: number): Promise<void> =>
  expect.poll(() => selected(page)).toBe(count);

/** Where the selected points are on screen. */
const marked = (page: Page): Promise<Place[]> =>
  page.locator(".marker.selected").evaluateAll((all) =>
    all.map((mark) => {
      const { x, y, width, height } = mark.getBoundingClientRect();
      return { x: x + width / 2, y: y + height / 2 };
    }),
  );

/** Selects the first visit's point and its neighbour to the right; gives the middle of their edge. */
async function selectEdge(page: Page): Promise<Place> {
  const at = await hintedPoint(page);
  await page.mouse.click(at.x, at.y);
  await page.keyboard.press("Control+ArrowRight");
  await expectSelected(page, 2);
  // A mark lies at the corner of the view until it is drawn.
  await expect
    .poll(async () => Math.abs(((await marked(page))[1]?.x ?? 0) - at.x))
    .toBeLessThan(60);
  const [a = at, b = at] = await marked(page);
  return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
}

it("what can be done with several points covers none of them, on a desk and a telephone", async () => {
  const page = await site.open();
  for (const [width, height] of [
    [900, 640],
    [390, 844],
  ] as const) {
    await page.setViewportSize({ width, height });
    await page.getByLabel("3D view").press("Escape");
    await selectEdge(page);
    const [view, box] = [await viewBox(page), await strip(page).boundingBox()];
    if (!box) throw new Error("no strip");
    const beside = box.x >= view.x + view.width || box.y >= view.y + view.height;
    expect(beside, `${width} × ${height}`).toBe(true);
    // Both points can still be pressed.
    for (const { x, y } of await marked(page)) {
      const hit = await page.evaluate(
        ([px = 0, py = 0]) => document.elementFromPoint(px, py)?.tagName,
        [x, y],
      );
      expect(hit).toBe("CANVAS");
    }
  }
  await page.context().close();
});
