// SPDX-License-Identifier: MIT
// Needs: layout.
// From the narrowest telephone to a 4K screen: nothing overlaps, sticks out or is cut short.
import type { Locator, Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { openFile, typeTarget } from "./support/page.ts";
import { site } from "./support/site.ts";
import { viewBox } from "./support/view.ts";

/** Width, height. 320 pixels are what is left of 1280 at 400 % zoom. */
const SIZES = [
  [320, 568],
  [360, 740],
  [667, 375],
  [740, 360],
  [768, 1024],
  [1280, 800],
  [2560, 1440],
  [3840, 2160],
] as const;

interface Rectangle {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

async function boxOf(locator: Locator): Promise<Rectangle> {
  const box = await locator.boundingBox();
  if (!box) throw new Error(`not shown: ${locator}`);
  return box;
}

const apart = (a: Rectangle, b: Rectangle): boolean =>
  a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;

const inside = (a: Rectangle, b: Rectangle): boolean =>
  a.x >= b.x && a.y >= b.y && a.x + a.width <= b.x + b.width && a.y + a.height <= b.y + b.height;

/** Names of buttons, fields and headings whose words do not fit. */
const cutShort = (page: Page): Promise<string[]> =>
  page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>("button, th, h2, label, .number, .slider-ends span")]
      .filter((element) => element.checkVisibility() && element.clientWidth > 1)
      .filter((element) => element.scrollWidth > element.clientWidth + 1)
      .map((element) => element.getAttribute("aria-label") ?? element.textContent ?? ""),
  );

describe.each(SIZES)("at %d × %d", (width, height) => {
  it("everything has its place", async () => {
    const page = await site.open({ viewport: { width, height }, reducedMotion: "reduce" });
    await typeTarget(page, "+0.2345m");
    const view = await viewBox(page);
    const window = { x: 0, y: 0, width, height };
    expect(view.width * view.height).toBeGreaterThan(0.3 * width * height);
    if (width < 900 && height > 559) expect(view.height).toBeGreaterThanOrEqual(0.49 * height);

    const over = await Promise.all(
      [
        page.getByRole("toolbar", { name: "Drag tools" }),
        page.getByRole("group", { name: "Views" }),
        page.getByRole("group", { name: "Legend" }),
      ].map(boxOf),
    );
    for (const [k, box] of over.entries()) {
      expect(inside(box, view), `part ${k} over the view`).toBe(true);
      for (const other of over.slice(k + 1)) expect(apart(box, other)).toBe(true);
    }
    for (const name of ["Open file", "Undo", "Redo", "Export", "Share", "Help", "Cancel"]) {
      const box = await boxOf(page.getByRole("button", { name, exact: true }));
      expect(inside(box, window), name).toBe(true);
    }
    const scroll = await page.evaluate<number[]>(
      "[document.documentElement.scrollWidth, document.documentElement.scrollHeight]",
    );
    expect(scroll).toEqual([width, height]);
    expect(await cutShort(page)).toEqual([]);
    await page.context().close();
  });
});

it("dialogs and menus fit a small screen", async () => {
  const page = await site.open({ viewport: { width: 320, height: 568 }, reducedMotion: "reduce" });
  const window = { x: 0, y: 0, width: 320, height: 568 };
  for (const name of ["Help", "Share"]) {
    await page.getByRole("button", { name, exact: true }).click();
    expect(inside(await boxOf(page.getByRole("dialog")), window), name).toBe(true);
    await page.keyboard.press("Escape");
  }
  await page.getByRole("button", { name: "Export" }).click();
  for (const name of ["OBJ", "GLB", "PLY", "PNG"]) {
    const box = await boxOf(page.getByRole("button", { name, exact: true }));
    expect(inside(box, window), name).toBe(true);
  }
  await page.context().close();
});

it.each([
  [390, 844],
  [740, 360],
])("the controls fold away at %d × %d, and come back", async (width, height) => {
  const page = await site.open({ viewport: { width, height }, reducedMotion: "reduce" });
  const before = await viewBox(page);
  const fold = page.getByRole("button", { name: "Controls", exact: true });
  expect(await fold.getAttribute("aria-expanded")).toBe("true");
  await fold.click();
  await expect
    .poll(async () => (await viewBox(page)).width * (await viewBox(page)).height)
    .toBeGreaterThan(1.3 * before.width * before.height);
  expect(inside(await boxOf(fold), { x: 0, y: 0, width, height })).toBe(true);
  expect(await page.getByRole("button", { name: "Add handle" }).isVisible()).toBe(false);
  await fold.click();
  await expect.poll(() => viewBox(page)).toEqual(before);
  await page.context().close();
});

const SADDLE = "v 0 0 0\nv 1 0 0.1\nv 1 1 0\nv 0 1 0.1\nf 1 2 3 4\n";

it.each([
  [360, 740],
  [740, 360],
  [768, 1024],
  [900, 640],
  [1440, 900],
])("the import report leaves the model in view at %d × %d", async (width, height) => {
  const page = await site.open({ viewport: { width, height }, reducedMotion: "reduce" });
  await openFile(page, "saddle.obj", SADDLE);
  const report = await boxOf(page.getByRole("region", { name: "saddle.obj" }));
  expect(apart(report, await viewBox(page))).toBe(true);
  for (const name of ["Planarise", "Leave as it is", "Open file", "Cancel"]) {
    const button = await boxOf(page.getByRole("button", { name, exact: true }));
    expect(inside(button, { x: 0, y: 0, width, height }), name).toBe(true);
  }
  expect(await cutShort(page)).toEqual([]);
  await page.context().close();
});
