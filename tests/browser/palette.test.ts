// SPDX-License-Identifier: MIT
// Needs: layout, pointer, focus.
// The palette: everything the page can be told, by a few letters, with keys and by touch.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle } from "./support/page.ts";
import { site } from "./support/site.ts";

const field = (page: Page) => page.getByRole("combobox", { name: "Command" });

const options = (page: Page) => page.getByRole("listbox", { name: "Commands" }).getByRole("option");

async function openPalette(page: Page): Promise<void> {
  await page.keyboard.press("Control+k");
  await expect
    .poll(() => field(page).evaluate((element) => element === document.activeElement))
    .toBe(true);
}

it("opens by touch, fits a telephone, runs by touch and leads to other dialogs", async () => {
  const [width, height] = [320, 568];
  const page = await site.open({ viewport: { width, height }, hasTouch: true });
  await page.getByRole("button", { name: "Help" }).tap();
  await page.getByRole("button", { name: "All commands" }).tap();
  await field(page).waitFor();
  await idle(page);
  const box = await page.getByRole("dialog").boundingBox();
  if (!box) throw new Error("no palette");
  expect(box.x).toBeGreaterThanOrEqual(0);
  expect(box.y).toBeGreaterThanOrEqual(0);
  expect(box.x + box.width).toBeLessThanOrEqual(width);
  expect(box.y + box.height).toBeLessThanOrEqual(height);
  await field(page).fill("sample: dome");
  await options(page).first().tap();
  await idle(page);
  expect(await page.getByRole("combobox", { name: "Sample" }).inputValue()).toBe("dome");
  // One command may open another dialog, which Escape leaves.
  for (const [letters, title] of [
    ["help", "How it works"],
    ["cutting", "Cutting package"],
    ["share", "Share this design"],
  ] as const) {
    await openPalette(page);
    await page.keyboard.type(letters);
    await page.keyboard.press("Enter");
    await page.getByRole("dialog", { name: title }).waitFor();
    await page.keyboard.press("Escape");
    expect(await page.getByRole("dialog").count()).toBe(0);
  }
  await page.context().close();
});
