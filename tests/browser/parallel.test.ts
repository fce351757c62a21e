// SPDX-License-Identifier: MIT
// Needs: pixels.
// Top, Front and Side are seen in parallel, as on a drawing; also after turning and reloading.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { exportAs, idle, movedCount, openFile, usable } from "./support/page.ts";
import { readPng } from "./support/pixels.ts";
import { site } from "./support/site.ts";
import { handleRows, hintedPoint, press, viewBox } from "./support/view.ts";

/** Of the panels' edges: darker than a shadow. */
const DARK = 110;

/** Walls without floor and roof, 6 by 4 by 5: from above in parallel only their rim is seen. */
const WALLS = `v 0 0 0\nv 6 0 0\nv 6 4 0\nv 0 4 0\nv 0 0 5\nv 6 0 5\nv 6 4 5\nv 0 4 5
f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n`;

interface Seen {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
  /** Dark pixels more than four within these. */
  readonly inside: number;
}

async function edges(page: Page): Promise<Seen> {
  const picture = readPng(await exportAs(page, "PNG"));
  const dark: (readonly [number, number])[] = [];
  for (let y = 0; y < picture.height; ++y)
    for (let x = 0; x < picture.width; ++x)
      if (Math.max(...picture.at(x, y)) < DARK) dark.push([x, y]);
  const [xs, ys] = [dark.map(([x]) => x), dark.map(([, y]) => y)];
  const [left, right] = [Math.min(...xs), Math.max(...xs)];
  const [top, bottom] = [Math.min(...ys), Math.max(...ys)];
  const within = ([x, y]: readonly [number, number]): boolean =>
    x > left + 4 && x < right - 4 && y > top + 4 && y < bottom - 4;
  return { left, right, top, bottom, inside: dark.filter(within).length };
}

const view = (page: Page, name: string): Promise<void> =>
  page.getByRole("button", { name, exact: true }).click();

it("a wall is a line from above, until Perspective; turning keeps the lens", async () => {
  const page = await site.open({ draws: true });
  await openFile(page, "walls.obj", WALLS);
  await page.getByRole("button", { name: "Start editing" }).click();
  await view(page, "Top");
  const plan = await edges(page);
  expect(plan.inside).toBe(0);
  expect((plan.right - plan.left) / (plan.bottom - plan.top)).toBeCloseTo(6 / 4, 1);
  await view(page, "Front");
  const front = await edges(page);
  expect(front.inside).toBe(0);
  expect((front.right - front.left) / (front.bottom - front.top)).toBeCloseTo(6 / 5, 1);
  // Turned about the upright axis only, uprights stay upright and rims level.
  await page.getByLabel("3D view").focus();
  for (let k = 0; k < 3; ++k) await page.keyboard.press("Shift+ArrowRight");
  const turned = await edges(page);
  expect(Math.abs(turned.bottom - turned.top - (front.bottom - front.top))).toBeLessThan(4);
  await view(page, "Perspective");
  await view(page, "Top");
  expect(await edges(page)).toEqual(plan);
  await page.context().close();
});

it("a point dragged in the plan follows the pointer; a link comes back in parallel, at its size", async () => {
  const page = await site.openVault({ draws: true });
  await view(page, "Top");
  const { left, right } = await edges(page);
  const from = await hintedPoint(page);
  await press(page, from, { x: from.x + 40, y: from.y });
  await page.mouse.up();
  await idle(page);
  const [row] = await handleRows(page);
  // The vault is 20 m wide and its middle point at 10 m.
  const [x = Number.NaN, y = Number.NaN] = row?.target ?? [];
  expect(x - 10).toBeCloseTo((40 * 20) / (right - left), 1);
  expect(y).toBeCloseTo(10, 2);
  const { width, height } = await viewBox(page);
  expect(right - left).toBeLessThan(Math.max(width, height));
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("-");
  const before = await edges(page);
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  const other = await site.open({ draws: true }, new URL(link).hash);
  await usable(other);
  await idle(other);
  await expect.poll(() => movedCount(other)).toBeGreaterThan(0);
  const after = await edges(other);
  // The view is lower where the page says that it opened a link.
  const share = (seen: Seen, height: number): number => (seen.right - seen.left) / height;
  const [old, now] = [(await viewBox(page)).height, (await viewBox(other)).height];
  expect(share(after, now) / share(before, old)).toBeGreaterThan(0.99);
  expect(share(after, now) / share(before, old)).toBeLessThan(1.01);
  expect(Math.abs(after.right - after.left - (after.bottom - after.top))).toBeLessThan(3);
  await other.context().close();
  await page.context().close();
});
