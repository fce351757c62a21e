// SPDX-License-Identifier: MIT
// The camera, fingers, before and after; and nothing is drawn when nothing changes.
import type { CDPSession, Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { idle, movedCount } from "./support/page.ts";
import { site } from "./support/site.ts";
import { handleRows, hintedPoint, type Place, press, viewBox } from "./support/view.ts";

const gap = (a: Place, b: Place): number => Math.hypot(a.x - b.x, a.y - b.y);

/** Fingers on the glass, one place each. */
type Touch = (
  type: "touchStart" | "touchMove" | "touchEnd",
  places: readonly Place[],
) => Promise<void>;

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

async function openPhone(): Promise<{ page: Page; touch: Touch }> {
  const page = await site.open({
    viewport: { width: 360, height: 740 },
    hasTouch: true,
    isMobile: true,
    reducedMotion: "reduce",
  });
  const session: CDPSession = await page.context().newCDPSession(page);
  const touch: Touch = async (type, places) => {
    const touchPoints = places.map(({ x, y }, id) => ({ x, y, id }));
    await session.send("Input.dispatchTouchEvent", { type, touchPoints });
  };
  return { page, touch };
}

/** Slides fingers from their places to others in steps, and lifts them. */
async function slide(touch: Touch, from: readonly Place[], to: readonly Place[]): Promise<void> {
  for (let k = 1; k <= from.length; ++k) await touch("touchStart", from.slice(0, k));
  for (let k = 1; k <= 6; ++k) {
    const between = from.map(({ x, y }, i) => ({
      x: x + (((to[i]?.x ?? x) - x) * k) / 6,
      y: y + (((to[i]?.y ?? y) - y) * k) / 6,
    }));
    await touch("touchMove", between);
  }
  await touch("touchEnd", []);
}

describe("fingers", () => {
  it("one on a point moves it", async () => {
    const { page, touch } = await openPhone();
    const at = await hintedPoint(page);
    await slide(touch, [at], [{ x: at.x, y: at.y - 40 }]);
    await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
    await idle(page);
    expect((await handleRows(page)).length).toBe(1);
    await page.context().close();
  });

  it("one beside the model turns the view and moves nothing", async () => {
    const { page, touch } = await openPhone();
    const at = await hintedPoint(page);
    const beside = await placeBesideTheTools(page);
    await slide(touch, [beside], [{ x: beside.x + 90, y: beside.y }]);
    await expect.poll(async () => gap(await hintedPoint(page), at)).toBeGreaterThan(5);
    expect(await movedCount(page)).toBe(0);
    await page.context().close();
  });

  it("two zoom and pan, even if the first lands on a point", async () => {
    const { page, touch } = await openPhone();
    const at = await hintedPoint(page);
    const other = { x: at.x + 30, y: at.y + 60 };
    await slide(
      touch,
      [at, other],
      [
        { x: at.x - 60, y: at.y + 20 },
        { x: other.x + 40, y: other.y + 90 },
      ],
    );
    await expect.poll(async () => gap(await hintedPoint(page), at)).toBeGreaterThan(10);
    expect(await movedCount(page)).toBe(0);
    expect(await handleRows(page)).toEqual([]);
    await page.context().close();
  });

  it("a tap selects a point, which a button pins", async () => {
    const { page, touch } = await openPhone();
    const at = await hintedPoint(page);
    await touch("touchStart", [at]);
    await touch("touchEnd", []);
    await page.getByRole("button", { name: "Pin selected points" }).tap();
    await idle(page);
    expect((await handleRows(page)).map((row) => row.pinned)).toEqual([true]);
    await page.context().close();
  });
});

describe("the camera", () => {
  it("goes to named views by buttons and keys, and fits the model again", async () => {
    const page = await site.open({ reducedMotion: "reduce" });
    const begin = await hintedPoint(page);
    let last = begin;
    for (const name of ["Front", "Top", "Side"]) {
      await page.getByRole("button", { name, exact: true }).click();
      const before = last;
      await expect.poll(async () => gap(before, await hintedPoint(page))).toBeGreaterThan(1);
      last = await hintedPoint(page);
    }
    await page.getByLabel("3D view").focus();
    await page.keyboard.press("1");
    await expect.poll(async () => gap(begin, await hintedPoint(page))).toBeLessThan(2);
    for (let k = 0; k < 5; ++k) await page.keyboard.press("+");
    await page.keyboard.press("f");
    await expect.poll(async () => gap(begin, await hintedPoint(page))).toBeLessThan(2);
    await page.context().close();
  });

  it("keeps the model in place when the window changes", async () => {
    const page = await site.open({ reducedMotion: "reduce" });
    await hintedPoint(page);
    await page.setViewportSize({ width: 1200, height: 800 });
    const { x, y, width, height } = await viewBox(page);
    await expect
      .poll(async () => {
        const at = await hintedPoint(page);
        return at.x > x && at.x < x + width && at.y > y && at.y < y + height;
      })
      .toBe(true);
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

describe("drawing", () => {
  it("happens on demand only", async () => {
    const page = await site.open();
    await hintedPoint(page);
    await page.waitForTimeout(1500);
    await countDraws(page);
    await page.waitForTimeout(1500);
    expect(await draws(page)).toBe(0);
    await page.getByRole("button", { name: "Top", exact: true }).click();
    await expect.poll(() => draws(page)).toBeGreaterThan(0);
    await page.waitForTimeout(1500);
    const after = await draws(page);
    await page.waitForTimeout(1000);
    expect(await draws(page)).toBe(after);
    await page.context().close();
  });

  it("goes on after the graphics card was lost", async () => {
    const page = await site.open();
    await hintedPoint(page);
    await page.getByLabel("3D view").evaluate(async (canvas: HTMLCanvasElement) => {
      const lose = canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context");
      lose?.loseContext();
      await new Promise((resolve) => setTimeout(resolve, 100));
      lose?.restoreContext();
    });
    await page.waitForTimeout(500);
    await countDraws(page);
    const at = await hintedPoint(page);
    await press(page, at, { x: at.x, y: at.y - 30 });
    await page.mouse.up();
    await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
    await expect.poll(() => draws(page)).toBeGreaterThan(0);
    await page.context().close();
  });
});

it("Before and the key B show the base while held", async () => {
  const page = await site.open({ reducedMotion: "reduce" });
  const at = await hintedPoint(page);
  await press(page, at, { x: at.x, y: at.y - 60 });
  await page.mouse.up();
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
  await page.waitForTimeout(800);
  const picture = (): Promise<Buffer> => page.getByLabel("3D view").screenshot();
  const before = page.getByRole("button", { name: "Before" });
  const edited = await picture();
  await page.getByLabel("3D view").focus();
  await page.keyboard.down("b");
  await expect.poll(() => before.getAttribute("aria-pressed")).toBe("true");
  await page.waitForTimeout(800);
  expect(await picture()).not.toEqual(edited);
  await page.keyboard.up("b");
  await expect.poll(() => before.getAttribute("aria-pressed")).toBe("false");
  await before.focus();
  await page.keyboard.down("Space");
  expect(await before.getAttribute("aria-pressed")).toBe("true");
  await page.keyboard.up("Space");
  expect(await before.getAttribute("aria-pressed")).toBe("false");
  await page.context().close();
});
