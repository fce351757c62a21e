// SPDX-License-Identifier: MIT
// The table of handles: every digit can be read, and many points are one row.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, movedCount, typeTarget } from "../browser/support/page.ts";
import { handleRows, hintedPoint, type Place, press } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

const table = (page: Page) => page.getByRole("table", { name: "Handles" });

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
  expect(await page.locator(".marker.pin.small").count()).toBe(pinned);
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
  const small = page.locator(".marker.handle.small");
  expect(await small.count()).toBe(0);
  await selectMany(page, at);
  await press(page, at, { x: at.x, y: at.y - 40 });
  await page.mouse.up();
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
  const group = table(page).getByRole("rowheader", { name: /^\d+ handles/ });
  await expect.poll(() => group.count()).toBe(1);
  const dragged = Number.parseInt((await group.textContent()) ?? "", 10);
  expect(dragged).toBeGreaterThan(24);
  // Their marks and the lines to where they were do not hide the bump.
  expect(await small.count()).toBe(await page.locator(".marker.handle").count());
  expect(await small.count()).toBeGreaterThanOrEqual(dragged);
  expect(await page.locator(".pull.thin").count()).toBe(await page.locator(".pull").count());
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

it("-= takes away; a minus alone is a place, which is said where it goes beyond 0", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+50cm");
  const z = table(page).getByRole("spinbutton", { name: "Z" }).first();
  const up = Number(await z.inputValue());
  expect(up).toBeGreaterThan(0.5);
  const type = async (text: string): Promise<void> => {
    await z.fill(text);
    await z.press("Enter");
    await idle(page);
  };
  await type("-=30cm");
  expect(Number(await z.inputValue())).toBeCloseTo(up - 0.3, 3);
  const words = page.getByText("Z: -0.3 is a place. To move by it, type -=0.3.");
  expect(await words.count()).toBe(0);
  await type("-0.3");
  expect(Number(await z.inputValue())).toBeCloseTo(-0.3, 3);
  await words.waitFor();
  await page.context().close();
});

it("a pin on a point that was moved says that it goes back; without it the point goes again", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+40cm");
  const moved = await movedCount(page);
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("p");
  await idle(page);
  await page
    .getByText(/^Pinned points stay where the mesh has them: point \d+ went back\./)
    .waitFor();
  expect(await movedCount(page)).toBe(0);
  await page.keyboard.press("p");
  await idle(page);
  expect(await movedCount(page)).toBe(moved);
  await page.context().close();
});
