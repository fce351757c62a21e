// SPDX-License-Identifier: MIT
// The table of handles: every digit can be read, and many points are one row.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, movedCount, openFile } from "./support/page.ts";
import { site } from "./support/site.ts";
import { handleRows, hintedPoint, type Place, press } from "./support/view.ts";

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

it.each([
  [1280, 800],
  [320, 568],
])("shows every digit of far coordinates and high numbers at %d × %d", async (width, height) => {
  const page = await site.openVault({ viewport: { width, height } });
  const { text, points } = farRoof();
  await openFile(page, "far.obj", text);
  await page.getByRole("button", { name: "Start editing" }).click();
  await page.getByRole("button", { name: "Add handle" }).click();
  await idle(page);
  const [row] = await handleRows(page);
  if (!row) throw new Error("no handle");
  expect(row.vertex).toBeGreaterThan(9999);
  const fields = page.getByRole("table", { name: "Handles" }).getByRole("spinbutton");
  for (const [axis, field] of (await fields.all()).entries()) {
    const shown = Number(await field.inputValue());
    expect(Math.abs(shown - (points[row.vertex]?.[axis] ?? Number.NaN))).toBeLessThan(6e-5);
    // What is typed is read the same way: the field shows it to the last digit.
    if (axis < 2) {
      const typed = `${shown < 0 ? "-" : ""}2599980.1234`;
      await field.fill(typed);
      expect(await fits(page), typed).toBe(true);
      await field.press("Escape");
    }
  }
  expect(await fits(page)).toBe(true);
  await page.context().close();
});

it("shows every digit of what fits into one line", async () => {
  const page = await site.openVault({ viewport: { width: 320, height: 568 } });
  await page.getByRole("button", { name: "Add handle" }).click();
  await idle(page);
  for (const field of await table(page).getByRole("spinbutton").all()) {
    await field.fill("-88.8888");
    expect(await fits(page)).toBe(true);
    await field.fill("-8888.8888");
    expect(await fits(page)).toBe(false);
    await field.press("Escape");
  }
  await page.context().close();
});

/** Selects a square of points about a place. */
async function selectMany(page: Page, { x, y }: Place): Promise<void> {
  await page.keyboard.down("Shift");
  await press(page, { x: x - 90, y: y - 60 }, { x: x + 90, y: y + 60 });
  await page.mouse.up();
  await page.keyboard.up("Shift");
}

it("many pins are one row, which selects, lists and removes them; P leaves no handles", async () => {
  const page = await site.openVault();
  await selectMany(page, await hintedPoint(page));
  await page.keyboard.press("p");
  await idle(page);
  const group = table(page).getByRole("rowheader", { name: /^\d+ pinned/ });
  await expect.poll(() => group.count()).toBe(1);
  const pinned = Number.parseInt((await group.textContent()) ?? "", 10);
  expect(pinned).toBeGreaterThan(24);
  // The row of all of them and that of the point that leads.
  const rows = table(page).locator("tbody").getByRole("row");
  expect(await rows.count()).toBe(2);
  await page.getByRole("button", { name: "List" }).click();
  await expect.poll(() => rows.count()).toBeGreaterThan(24);
  await page.getByRole("button", { name: "List" }).click();
  await page.keyboard.press("Escape");
  await expect.poll(() => rows.count()).toBe(1);
  await page.getByRole("button", { name: "Select", exact: true }).click();
  await page.keyboard.press("p");
  await idle(page);
  await expect.poll(() => rows.count()).toBe(0);
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  await expect.poll(() => group.count()).toBe(1);
  await table(page).getByRole("button", { name: "Remove" }).first().click();
  await idle(page);
  await expect.poll(() => rows.count()).toBe(0);
  await page.context().close();
});

it("Add handle takes one of many, a drag of many is one row, and all can be removed", async () => {
  const page = await site.openVault();
  const at = await hintedPoint(page);
  await selectMany(page, at);
  await page.getByRole("button", { name: "Add handle" }).click();
  await idle(page);
  expect((await handleRows(page)).length).toBe(1);
  await selectMany(page, at);
  await press(page, at, { x: at.x, y: at.y - 40 });
  await page.mouse.up();
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
  const group = table(page).getByRole("rowheader", { name: /^\d+ handles/ });
  await expect.poll(() => group.count()).toBe(1);
  expect(Number.parseInt((await group.textContent()) ?? "", 10)).toBeGreaterThan(24);
  expect(await table(page).locator("tbody").getByRole("row").count()).toBe(2);
  await page.getByRole("button", { name: "Remove all" }).click();
  await idle(page);
  expect(await movedCount(page)).toBe(0);
  expect(await table(page).locator("tbody").getByRole("row").count()).toBe(0);
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  expect(await movedCount(page)).toBeGreaterThan(0);
  await page.context().close();
});
