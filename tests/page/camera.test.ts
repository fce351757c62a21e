// SPDX-License-Identifier: MIT
// The camera follows the work: it zooms to the pointer, turns about the edit and fits what is selected.
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { hintedPoint, type Place } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

const gap = (a: Place, b: Place): number => Math.hypot(a.x - b.x, a.y - b.y);

/** Where the marked points are on screen, in the order in which they were marked. */
async function marks(page: Page): Promise<Place[]> {
  const boxes = await page.locator(".marker").evaluateAll((all) =>
    all.map((mark) => {
      const { x, y, width, height } = mark.getBoundingClientRect();
      return { x: x + width / 2, y: y + height / 2 };
    }),
  );
  return boxes;
}

const mark = async (page: Page): Promise<Place> => {
  const [first] = await marks(page);
  if (!first) throw new Error("nothing is marked");
  return first;
};

/** Pixels between two neighbours that are marked: how large the model is on screen. */
const size = async (page: Page): Promise<number> => {
  const [a, b] = await marks(page);
  if (!a || !b) throw new Error("two points are not marked");
  return gap(a, b);
};

/** Until what is asked for has been drawn, and drawn again the same. */
async function rest(page: Page): Promise<void> {
  let last = await marks(page);
  await expect
    .poll(async () => {
      await page.evaluate(
        () => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))),
      );
      const [before, now] = [last, await marks(page)];
      last = now;
      return Math.max(0, ...now.map((at, k) => gap(at, before[k] ?? at)));
    })
    .toBeLessThan(0.01);
}

/** Selects the first visit's point and a neighbour; the point was selected first. */
async function selectTwo(page: Page): Promise<Place> {
  const at = await hintedPoint(page);
  await page.mouse.click(at.x, at.y);
  await page.keyboard.press("Control+ArrowRight");
  await expect.poll(async () => (await marks(page)).length).toBe(2);
  return mark(page);
}

describe("the wheel", () => {
  it.each(["Perspective", "Top"])("keeps the point under the pointer: %s", async (view) => {
    const page = await site.open();
    await selectTwo(page);
    await page.getByRole("button", { name: view, exact: true }).click();
    await rest(page);
    const [at, before] = [await mark(page), await size(page)];
    await page.mouse.move(at.x, at.y);
    for (let tick = 0; tick < 10; ++tick) {
      await page.mouse.wheel(0, -120);
      await rest(page);
      expect(gap(await mark(page), at)).toBeLessThan(2);
    }
    expect(await size(page)).toBeGreaterThan(1.5 * before);
    for (let tick = 0; tick < 10; ++tick) await page.mouse.wheel(0, 120);
    await rest(page);
    expect(gap(await mark(page), at)).toBeLessThan(2);
    expect(Math.abs((await size(page)) - before)).toBeLessThan(2);
    await page.context().close();
  });
});

describe("the keys of the view", () => {
  it("step from point to point with the focus on a tool", async () => {
    const page = await site.open();
    await page.getByRole("button", { name: "Snap", exact: true }).focus();
    await page.keyboard.press("ArrowRight");
    await expect.poll(() => page.locator(".marker.selected").count()).toBe(1);
    await page.context().close();
  });
});
