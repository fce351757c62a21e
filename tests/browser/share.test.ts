// SPDX-License-Identifier: MIT
// Needs: storage.
// A link over a design that was kept.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { exportAs, idle, kept, showTab, typeTarget, usable } from "./support/page.ts";
import { site } from "./support/site.ts";

async function linkOf(page: Page): Promise<string> {
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  await page.keyboard.press("Escape");
  return link;
}

it("a link opened over a kept design keeps that one; after an edit a reload keeps the edit", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+30cm");
  const link = await linkOf(page);
  await typeTarget(page, "+20cm");
  const design = await exportAs(page, "OBJ");
  await kept(page);
  const tab = await page.context().newPage();
  await page.close();
  await tab.goto(link);
  await expect.poll(() => tab.getByText(/Verified/).count()).toBe(1);
  await idle(tab);
  await typeTarget(tab, "+10cm");
  const edited = await exportAs(tab, "OBJ");
  await kept(tab);
  await tab.reload();
  await usable(tab);
  await idle(tab);
  expect(await exportAs(tab, "OBJ")).toEqual(edited);
  await showTab(tab, "Explore");
  await tab.getByRole("button", { name: "Adopt Before the link" }).click();
  await idle(tab);
  expect(await exportAs(tab, "OBJ")).toEqual(design);
  await tab.context().close();
});
