// SPDX-License-Identifier: MIT
// Needs: pointer, pixels.
// Fingers; and nothing is drawn when nothing changes.
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { expectClean } from "./support/axe.ts";
import { idle, movedCount, still } from "./support/page.ts";
import { site } from "./support/site.ts";
import { openPhone, slide, type Touch } from "./support/touch.ts";
import { handleRows, hintedPoint, type Place, viewBox } from "./support/view.ts";

const gap = (a: Place, b: Place): number => Math.hypot(a.x - b.x, a.y - b.y);

/** The lowest place at the left edge of the view where nothing lies over it. */
async function placeBesideTheTools(page: Page): Promise<Place> {
  const { x, y, height } = await viewBox(page);
  const free = await page.evaluate(
    ([left, top, bottom]) => {
      for (let place = bottom - 20; place > top; place -= 10) {
        if (document.elementFromPoint(left, place)?.tagName === "CANVAS") return place;
      }
      return null;
    },
    [x + 24, y, y + height] as const,
  );
  if (free === null) throw new Error("The tools cover the left edge of the view.");
  return { x: x + 24, y: free };
}

/** How many different colours the loupe shows. */
const coloursIn = (page: Page): Promise<number> =>
  page.locator(".loupe").evaluate((glass: HTMLCanvasElement) => {
    const { width, height } = glass;
    const data = glass.getContext("2d")?.getImageData(0, 0, width, height).data ?? [];
    const seen = new Set<string>();
    for (let k = 0; k < data.length; k += 4) seen.add([...data.slice(k, k + 3)].join());
    return seen.size;
  });

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

/** A loop drawn by a finger, where the tool is chosen, selects the points that it goes round. */
async function drawLoop(page: Page, touch: Touch): Promise<void> {
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
}

describe("fingers", () => {
  it("one on a point moves it, which is kept or taken back beside the point", async () => {
    const { page, touch } = await openPhone();
    const at = await hintedPoint(page);
    const offer = page.getByRole("group", { name: /^Point \d+ was dragged$/ });
    const drag = async (): Promise<void> => {
      await slide(touch, [at], [{ x: at.x, y: at.y - 40 }]);
      await offer.waitFor();
      await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
      await idle(page);
      expect((await handleRows(page)).length).toBe(1);
    };
    await drag();
    for (const button of await offer.getByRole("button").all()) {
      const box = await button.boundingBox();
      expect(Math.min(box?.width ?? 0, box?.height ?? 0)).toBeGreaterThanOrEqual(44);
    }
    await page.getByText(/Keep it, or take it back$/).waitFor({ state: "attached" });
    await expectClean(page, "after a drag by a finger");
    await offer.getByRole("button", { name: "Discard" }).tap();
    await expect.poll(() => movedCount(page)).toBe(0);
    expect(await offer.count()).toBe(0);
    await idle(page);
    await drag();
    const view = await viewBox(page);
    await offer.getByRole("button", { name: "Keep" }).tap();
    expect(await offer.count()).toBe(0);
    expect(await viewBox(page)).toEqual(view);
    expect(await movedCount(page)).toBeGreaterThan(0);
    await page.context().close();
  });

  it("one that drags a point sees it in a loupe, clear of the finger, until it is lifted", async () => {
    const { page, touch } = await openPhone(true);
    const at = await hintedPoint(page);
    const loupe = page.locator(".loupe");
    await touch("touchStart", [at]);
    for (let k = 1; k <= 4; ++k) await touch("touchMove", [{ x: at.x, y: at.y - 12 * k }]);
    await loupe.waitFor();
    const finger = { x: at.x + 4, y: at.y - 60 };
    await touch("touchMove", [finger]);
    const farEnough = async (): Promise<number> => {
      const box = await loupe.boundingBox();
      if (!box) return 0;
      const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
      return gap(middle, finger) - box.width / 2;
    };
    await expect.poll(farEnough).toBeGreaterThan(25);
    // It holds a picture, with the mark of the point that is dragged.
    await expect.poll(() => coloursIn(page)).toBeGreaterThan(20);
    await touch("touchEnd", []);
    await expect.poll(() => loupe.isVisible()).toBe(false);
    await idle(page);
    await page.context().close();
  });

  it("one beside the model turns the view, two zoom and pan, a tap selects, a loop holds", async () => {
    const { page, touch } = await openPhone();
    const at = await hintedPoint(page);
    const beside = await placeBesideTheTools(page);
    await slide(touch, [beside], [{ x: beside.x + 90, y: beside.y }]);
    await expect.poll(async () => gap(await hintedPoint(page), at)).toBeGreaterThan(5);
    expect(await movedCount(page)).toBe(0);
    // Even if the first of two lands on a point.
    const turned = await hintedPoint(page);
    const other = { x: turned.x + 30, y: turned.y + 60 };
    await slide(
      touch,
      [turned, other],
      [
        { x: turned.x - 60, y: turned.y + 20 },
        { x: other.x + 40, y: other.y + 90 },
      ],
    );
    await expect.poll(async () => gap(await hintedPoint(page), turned)).toBeGreaterThan(10);
    expect(await movedCount(page)).toBe(0);
    expect(await handleRows(page)).toEqual([]);
    await page.getByRole("button", { name: "Perspective", exact: true }).tap();
    await page.getByRole("button", { name: "Fit", exact: true }).tap();
    await still(page);
    const first = await hintedPoint(page);
    await touch("touchStart", [first]);
    await touch("touchEnd", []);
    await page.getByRole("button", { name: "Pin selected points" }).tap();
    await idle(page);
    expect((await handleRows(page)).map((row) => row.pinned)).toEqual([true]);
    await drawLoop(page, touch);
    expect(await movedCount(page)).toBe(0);
    await page.context().close();
  });
});

/** Counts what is drawn from now on. */
const countDraws = (page: Page): Promise<void> =>
  page.evaluate(() => {
    const { prototype } = WebGL2RenderingContext;
    const scope = window as unknown as { draws: number };
    scope.draws = 0;
    for (const name of ["drawElements", "drawArrays", "drawElementsInstanced"] as const) {
      const draw = prototype[name] as (...args: unknown[]) => void;
      Object.assign(prototype, {
        [name](this: WebGL2RenderingContext, ...args: unknown[]) {
          scope.draws += 1;
          draw.apply(this, args);
        },
      });
    }
  });

const draws = (page: Page): Promise<number> =>
  page.evaluate(() => (window as unknown as { draws: number }).draws);

/** Waits until the browser has made so many pictures of the page. */
const frames = (page: Page, count: number): Promise<void> =>
  page.evaluate(async (many) => {
    for (let k = 0; k < many; ++k) await new Promise(requestAnimationFrame);
  }, count);

describe("drawing", () => {
  it("happens on demand only", async () => {
    const page = await site.open({ draws: true });
    await hintedPoint(page);
    await still(page);
    await countDraws(page);
    await frames(page, 60);
    expect(await draws(page)).toBe(0);
    await page.getByRole("button", { name: "Top", exact: true }).click();
    await expect.poll(() => draws(page)).toBeGreaterThan(0);
    await still(page);
    const after = await draws(page);
    await frames(page, 60);
    expect(await draws(page)).toBe(after);
    await page.context().close();
  });
});
