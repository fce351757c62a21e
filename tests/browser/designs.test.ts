// SPDX-License-Identifier: MIT
// Needs: storage.
// A design is data: every step can be undone, kept under a name, adopted from the gallery.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, kept, obj, status, typeTarget } from "./support/page.ts";
import { site } from "./support/site.ts";

const press = async (page: Page, name: string): Promise<void> => {
  await page.getByRole("button", { name, exact: true }).click();
  await idle(page);
};

async function findVariations(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Find variations" }).click();
  const gallery = page.getByRole("list", { name: "Gallery of variations" });
  await expect.poll(() => gallery.getAttribute("aria-busy")).toBe("false");
  await idle(page);
}

async function slide(page: Page, name: string, value: string): Promise<void> {
  await page.getByRole("slider", { name, exact: true }).fill(value);
  await idle(page);
}

it("keeps the sliders through undo, redo and a reload", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+70cm");
  await findVariations(page);
  const slider = page.getByRole("slider", { name: "Variation 1", exact: true });
  await slide(page, "Variation 1", "0.5");
  const varied = await obj(page);
  await press(page, "Undo");
  await press(page, "Undo");
  expect(await slider.count()).toBe(0);
  await press(page, "Redo");
  await press(page, "Redo");
  expect(await slider.inputValue()).toBe("0.5");
  await slide(page, "Variation 1", "-0.25");
  await slide(page, "Variation 1", "0.5");
  expect(await obj(page)).toBe(varied);
  await kept(page);
  await page.reload();
  await expect.poll(() => status(page)).toMatch(/[1-9]\d* of 441 points move/);
  await idle(page);
  expect(await obj(page)).toBe(varied);
  await slide(page, "Variation 1", "-0.25");
  await slide(page, "Variation 1", "0.5");
  expect(await obj(page)).toBe(varied);
  expect(await page.getByRole("button", { name: "Show gallery" }).count()).toBe(1);
  await page.context().close();
});
