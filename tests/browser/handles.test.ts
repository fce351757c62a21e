// SPDX-License-Identifier: MIT
// Needs: layout.
// The table of handles: every digit can be read, and many points are one row.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, openFile } from "./support/page.ts";
import { site } from "./support/site.ts";
import { handleRows, hintedPoint, press } from "./support/view.ts";

const SIDE = 101;

const [EAST, NORTH] = [2599980.1234, -2599980.1234];

/** A flat square far from the origin; the nearer a point to the middle, the higher its number. */
function farRoof(): { readonly text: string; readonly points: readonly (readonly number[])[] } {
  const cells = Array.from({ length: SIDE * SIDE }, (_, k) => [k % SIDE, Math.floor(k / SIDE)]);
  const away = ([i = 0, j = 0]: readonly number[]): number =>
    Math.max(Math.abs(i - (SIDE - 1) / 2), Math.abs(j - (SIDE - 1) / 2));
  const order = cells.toSorted((a, b) => away(b) - away(a));
  const numbers = new Map(order.map(([i = 0, j = 0], k) => [j * SIDE + i, k + 1]));
  const points = order.map(([i = 0, j = 0]) => [EAST + i, NORTH + j, 0.0625 * i]);
  const faces: string[] = [];
  for (let j = 0; j + 1 < SIDE; ++j) {
    for (let i = 0; i + 1 < SIDE; ++i) {
      const at = j * SIDE + i;
      const corners = [at, at + 1, at + SIDE + 1, at + SIDE].map((cell) => numbers.get(cell));
      faces.push(`f ${corners.join(" ")}`);
    }
  }
  const lines = points.map((point) => `v ${point.join(" ")}`);
  return { text: [...lines, ...faces].join("\n"), points };
}

const table = (page: Page) => page.getByRole("table", { name: "Handles" });

/** Whether the words of every field and point number in the table can be seen whole. */
const fits = (page: Page): Promise<boolean> =>
  table(page).evaluate((handles) =>
    [...handles.querySelectorAll("input[type=text], button")].every((part) => {
      const { left, right } = part.getBoundingClientRect();
      const { left: from, right: to } = handles.getBoundingClientRect();
      return part.scrollWidth <= part.clientWidth && left >= from && right <= to;
    }),
  );

/** The row of many pins goes the whole way across the table, its words and buttons on one line. */
async function expectOneLine(page: Page): Promise<void> {
  const { x, y } = await hintedPoint(page);
  await page.keyboard.down("Shift");
  await press(page, { x: x - 90, y: y - 60 }, { x: x + 90, y: y + 60 });
  await page.mouse.up();
  await page.keyboard.up("Shift");
  await page.keyboard.press("p");
  await idle(page);
  const row = table(page)
    .getByRole("row")
    .filter({ hasText: /^\d+ pinned/ });
  const wide = await table(page).boundingBox();
  const box = await row.boundingBox();
  expect(box?.width).toBeGreaterThan(0.95 * (wide?.width ?? Number.POSITIVE_INFINITY));
  const tops = await row
    .getByRole("button")
    .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().top));
  expect(tops.length).toBeGreaterThan(2);
  expect(Math.max(...tops) - Math.min(...tops)).toBeLessThan(12);
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
}

it("shows every digit of far coordinates and high numbers, on a desk and a telephone", async () => {
  const page = await site.openVault({ viewport: { width: 1280, height: 800 } });
  await expectOneLine(page);
  const { text, points } = farRoof();
  await openFile(page, "far.obj", text);
  await page.getByRole("button", { name: "Start editing" }).click();
  await page.getByRole("button", { name: "Add handle" }).click();
  await idle(page);
  const [row] = await handleRows(page);
  if (!row) throw new Error("no handle");
  expect(row.vertex).toBeGreaterThan(9999);
  await expectFigures(page, points[row.vertex] ?? []);
  await page.setViewportSize({ width: 320, height: 568 });
  await expectFigures(page, points[row.vertex] ?? []);
  await expectLine(page);
  await page.context().close();
});

/** The coordinates of `point` stand in the table to the last digit, as what is typed there does. */
async function expectFigures(page: Page, point: readonly number[]): Promise<void> {
  const fields = page.getByRole("table", { name: "Handles" }).getByRole("spinbutton");
  for (const [axis, field] of (await fields.all()).entries()) {
    const shown = Number(await field.inputValue());
    expect(Math.abs(shown - (point[axis] ?? Number.NaN))).toBeLessThan(6e-5);
    // What is typed is read the same way: the field shows it to the last digit.
    if (axis < 2) {
      const typed = `${shown < 0 ? "-" : ""}2599980.1234`;
      await field.fill(typed);
      expect(await fits(page), typed).toBe(true);
      await field.press("Escape");
    }
  }
  expect(await fits(page)).toBe(true);
}

/** Every digit of what fits into one line is shown. */
async function expectLine(page: Page): Promise<void> {
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Vault");
  await idle(page);
  await page.getByRole("button", { name: "Add handle" }).click();
  await idle(page);
  for (const field of await table(page).getByRole("spinbutton").all()) {
    await field.fill("-88.8888");
    expect(await fits(page)).toBe(true);
    await field.fill("-8888.8888");
    expect(await fits(page)).toBe(false);
    await field.press("Escape");
  }
}
