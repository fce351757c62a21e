// SPDX-License-Identifier: MIT
// Needs: pixels.
// What is selected is what was clicked, and the arrows stand where the selected point is.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, openFile, still } from "./support/page.ts";
import { type Picture, readPng } from "./support/pixels.ts";
import { site } from "./support/site.ts";
import { hintedPoint, type Place, viewBox } from "./support/view.ts";

type Colour = readonly [number, number, number];

/** Pixels of the view, without what lies over it, that a test of their colour holds for. */
async function pixels(page: Page, holds: (colour: Colour) => boolean): Promise<Place[]> {
  const show = (visibility: string): Promise<void> =>
    page.locator("canvas#view ~ *").evaluateAll((over, visibility) => {
      for (const element of over as HTMLElement[]) element.style.visibility = visibility;
    }, visibility);
  await show("hidden");
  const picture: Picture = readPng(await page.locator("canvas#view").screenshot());
  await show("");
  const { x: left, y: top } = await viewBox(page);
  const found: Place[] = [];
  for (let y = 0; y < picture.height; ++y)
    for (let x = 0; x < picture.width; ++x)
      if (holds(picture.at(x, y))) found.push({ x: left + x, y: top + y });
  return found;
}

const middle = (values: readonly number[]): number =>
  values.reduce((sum, value) => sum + value, 0) / values.length;

const near =
  (wanted: Colour) =>
  (colour: Colour): boolean =>
    colour.every((value, k) => Math.abs(value - (wanted[k] ?? 0)) < 16);

/** Where the arrows meet, seen from above: X goes right from there, Y up. */
async function arrowsAt(page: Page): Promise<Place> {
  const red = await pixels(page, near([0xc2, 0x45, 0x3a]));
  const green = await pixels(page, near([0x3c, 0x8a, 0x4e]));
  return { x: middle(green.map(({ x }) => x)), y: middle(red.map(({ y }) => y)) };
}

/** Four panels of 1 m: 0 and 1 in front, 2 and 3 behind them. */
const FOUR = `${[0, 1, 2].flatMap((y) => [0, 1, 2].map((x) => `v ${x} ${y} 0`)).join("\n")}
f 1 2 5 4\nf 2 3 6 5\nf 4 5 8 7\nf 5 6 9 8\n`;

it("a click in the view selects the panel under it, and beside the model none", async () => {
  const page = await site.openVault({ draws: true });
  await openFile(page, "four.obj", FOUR);
  await page.getByRole("button", { name: "Start editing" }).click();
  await page.getByRole("button", { name: "Top", exact: true }).click();
  const edges = await pixels(page, (colour) => Math.max(...colour) < 110);
  const [xs, ys] = [edges.map(({ x }) => x), edges.map(({ y }) => y)];
  const [left, right] = [Math.min(...xs), Math.max(...xs)];
  const [top, bottom] = [Math.min(...ys), Math.max(...ys)];
  const figure = page.getByText(/^Panel \d+ 4 corners/);
  for (const panel of [0, 3, 1, 2]) {
    const across = panel % 2 === 0 ? 0.27 : 0.73;
    const down = panel < 2 ? 0.73 : 0.27;
    await page.mouse.click(left + across * (right - left), top + down * (bottom - top));
    await expect.poll(() => figure.textContent()).toContain(`Panel ${panel} 4 corners, flat`);
  }
  await page.mouse.click(left - 60, top + 20);
  await expect.poll(() => figure.count()).toBe(0);
  await page.context().close();
});

it("the arrows stand at the selected point, before it is moved and after", async () => {
  const page = await site.openVault({ draws: true, viewport: { width: 1440, height: 900 } });
  await page.getByRole("button", { name: "Top", exact: true }).click();
  await still(page);
  const point = await hintedPoint(page);
  await page.getByRole("button", { name: "Add handle" }).click();
  await idle(page);
  await still(page);
  const first = await arrowsAt(page);
  expect(Math.hypot(first.x - point.x, first.y - point.y)).toBeLessThan(3);
  const fields = page.getByRole("table", { name: "Handles" });
  await fields.getByRole("spinbutton", { name: "X" }).fill("+1m");
  await fields.getByRole("spinbutton", { name: "X" }).press("Enter");
  await idle(page);
  await still(page);
  const second = await arrowsAt(page);
  expect(second.x - first.x).toBeGreaterThan(18);
  expect(Math.abs(second.y - first.y)).toBeLessThan(3);
  // The point itself is there: it answers to the pointer, which reaches less far than it moved.
  await page.mouse.move(point.x, point.y + 200);
  await page.mouse.move(second.x, second.y);
  await page.getByText(/^Point \d+ moved \d+ mm/).waitFor();
  await page.context().close();
});
