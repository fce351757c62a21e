// SPDX-License-Identifier: MIT
// Needs: pointer, pixels.
// The camera, fingers, before and after; and nothing is drawn when nothing changes.
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { expectClean } from "./support/axe.ts";
import { idle, movedCount, still } from "./support/page.ts";
import { readPng } from "./support/pixels.ts";
import { site } from "./support/site.ts";
import { openPhone, slide } from "./support/touch.ts";
import { handleRows, hintedPoint, type Place, press, viewBox } from "./support/view.ts";

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

  it("one that dragged a point keeps that or takes it back, beside the point", async () => {
    const { page, touch } = await openPhone();
    const at = await hintedPoint(page);
    const offer = page.getByRole("group", { name: /^Point \d+ was dragged$/ });
    const drag = async (): Promise<void> => {
      await slide(touch, [at], [{ x: at.x, y: at.y - 40 }]);
      await offer.waitFor();
    };
    await drag();
    for (const button of await offer.getByRole("button").all()) {
      const box = await button.boundingBox();
      expect(Math.min(box?.width ?? 0, box?.height ?? 0)).toBeGreaterThanOrEqual(44);
    }
    await page.getByText(/Keep it, or take it back$/).waitFor({ state: "attached" });
    await expectClean(page, "after a drag by a finger");
    await offer.getByRole("button", { name: "Take back" }).tap();
    await expect.poll(() => movedCount(page)).toBe(0);
    expect(await offer.count()).toBe(0);
    await idle(page);
    await drag();
    await idle(page);
    const view = await viewBox(page);
    await offer.getByRole("button", { name: "Keep" }).tap();
    expect(await offer.count()).toBe(0);
    expect(await viewBox(page)).toEqual(view);
    expect(await movedCount(page)).toBeGreaterThan(0);
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

  it("goes on after the graphics card was lost", async () => {
    const page = await site.open({ draws: true });
    await hintedPoint(page);
    await page.getByLabel("3D view").evaluate(async (canvas: HTMLCanvasElement) => {
      const lose = canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context");
      lose?.loseContext();
      await new Promise((resolve) => setTimeout(resolve, 100));
      lose?.restoreContext();
    });
    await still(page);
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
  const page = await site.open({ draws: true, reducedMotion: "reduce" });
  const at = await hintedPoint(page);
  await press(page, at, { x: at.x, y: at.y - 60 });
  await page.mouse.up();
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
  await still(page);
  const picture = (): Promise<Buffer> => page.getByLabel("3D view").screenshot();
  const before = page.getByRole("button", { name: "Before" });
  const edited = await picture();
  await page.getByLabel("3D view").focus();
  await page.keyboard.down("b");
  await expect.poll(() => before.getAttribute("aria-pressed")).toBe("true");
  await still(page);
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

it("at rest, without figures in its colours, the ground beside the model is shaded", async () => {
  const page = await site.openVault({ draws: true });
  const view = page.getByLabel("3D view");
  const colour = page.getByRole("combobox", { name: "Colour by" });
  const picture = async () => readPng(await view.screenshot());
  await colour.selectOption("Planarity");
  await still(page);
  const plain = await picture();
  const [paper] = plain.at(plain.width - 4, plain.height >> 1);
  /** Pixels of bare paper that are darker now. */
  const shaded = async (): Promise<number> => {
    const now = await picture();
    let count = 0;
    for (let x = 0; x < now.width; ++x)
      for (let y = 80; y < now.height; ++y)
        if (plain.at(x, y)[0] === paper && now.at(x, y)[0] < paper - 6) ++count;
    return count;
  };
  expect(await shaded()).toBeLessThan(20);
  await colour.selectOption("Nothing");
  await expect.poll(shaded).toBeGreaterThan(400);
  await page.context().close();
});
