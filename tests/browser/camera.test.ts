// SPDX-License-Identifier: MIT
// Needs: pointer.
// The camera follows the work: it zooms to the pointer, turns about the edit and fits what is selected.
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { idle, still, typeTarget } from "./support/page.ts";
import { site } from "./support/site.ts";
import { hintedPoint, type Place, press, viewBox } from "./support/view.ts";

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

/** A place at the lower edge of the view where a press turns it, whatever is selected. */
async function emptyPlace(page: Page): Promise<Place> {
  const { x, y, width, height } = await viewBox(page);
  return { x: x + 0.55 * width, y: y + height - 8 };
}

describe("a turn", () => {
  it("is about the selected point, which F fits", async () => {
    const page = await site.open();
    const at = await hintedPoint(page);
    await page.mouse.click(at.x, at.y);
    await page.keyboard.press("Control+ArrowRight");
    await page.keyboard.press("Control+ArrowUp");
    await expect.poll(async () => (await marks(page)).length).toBe(3);
    await still(page);
    const [from, before] = [await emptyPlace(page), await marks(page)];
    await press(page, from, { x: from.x + 140, y: from.y - 60 });
    await page.mouse.up();
    await still(page);
    const after = await marks(page);
    const moved = after.map((place, k) => gap(place, before[k] ?? place));
    // The point chosen last leads; about it the others go round.
    expect(moved[2]).toBeLessThan(2);
    expect(moved[0]).toBeGreaterThan(5);
    for (let k = 0; k < 4; ++k) await page.keyboard.press("Shift+ArrowLeft");
    await still(page);
    const turned = await marks(page);
    expect(gap(turned[2] ?? from, before[2] ?? from)).toBeLessThan(2);
    expect(gap(turned[0] ?? from, after[0] ?? from)).toBeGreaterThan(2);
    await fitSelection(page);
    await page.context().close();
  });

  it("is about the place pressed on the model where nothing is selected", async () => {
    const page = await site.open();
    await typeTarget(page, "+10cm");
    await page.keyboard.press("Tab");
    await page.getByLabel("3D view").focus();
    await page.keyboard.press("Escape");
    const at = await mark(page);
    // Near enough to tell what a turn is about, and to the side of the middle.
    await page.mouse.move(at.x, at.y);
    for (let tick = 0; tick < 25; ++tick) await page.mouse.wheel(0, -120);
    await still(page);
    const handle = await mark(page);
    const from = { x: handle.x + 26, y: handle.y + 22 };
    await press(page, from, { x: from.x + 160, y: from.y + 10 });
    await page.mouse.up();
    await still(page);
    expect(gap(await mark(page), handle)).toBeGreaterThan(1);
    expect(gap(await mark(page), handle)).toBeLessThan(60);
    await page.context().close();
  });
});

/** F fits the selection, Shift F all of the model. */
async function fitSelection(page: Page): Promise<void> {
  await page.keyboard.press("Shift+F");
  await still(page);
  const [at, before] = [await mark(page), await size(page)];
  await page.keyboard.press("f");
  await still(page);
  expect(await size(page)).toBeGreaterThan(3 * before);
  const { x, y, width, height } = await viewBox(page);
  for (const place of await marks(page)) {
    expect(Math.abs(place.x - x - width / 2)).toBeLessThan(width / 4);
    expect(Math.abs(place.y - y - height / 2)).toBeLessThan(height / 4);
  }
  await page.keyboard.press("Shift+F");
  await still(page);
  expect(gap(await mark(page), at)).toBeLessThan(2);
  expect(Math.abs((await size(page)) - before)).toBeLessThan(1);
}

const isLocked = async (page: Page): Promise<boolean> =>
  (await page.getByRole("button", { name: "Lock to X" }).getAttribute("aria-pressed")) === "true";

describe("the keys of the view", () => {
  it("work with the focus anywhere but in a field", async () => {
    const page = await site.open();
    await typeTarget(page, "+40cm");
    await idle(page);
    const places = [
      page.getByRole("button", { name: "Export" }),
      page.getByRole("button", { name: "Add handle" }),
      page.getByRole("checkbox", { name: "Pinned" }),
      page.getByRole("slider").first(),
      page.getByRole("button", { name: "Top", exact: true }),
      page.getByLabel("3D view"),
    ];
    for (const [k, place] of places.entries()) {
      await place.focus();
      await page.keyboard.press("x");
      await expect.poll(() => isLocked(page), { message: `place ${k}` }).toBe(k % 2 === 0);
    }
    const field = page.getByRole("spinbutton", { name: "Z", exact: true });
    for (const place of [field, page.getByRole("combobox", { name: "Sample" })]) {
      await place.focus();
      await page.keyboard.press("x");
      expect(await isLocked(page)).toBe(false);
    }
    await page.keyboard.press("Escape");
    await page.getByRole("button", { name: "Help" }).click();
    await page.keyboard.press("x");
    await page.keyboard.press("Escape");
    expect(await isLocked(page)).toBe(false);
    await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
    await page.keyboard.press("x");
    await expect.poll(() => isLocked(page)).toBe(true);
    await page.context().close();
  });
});
