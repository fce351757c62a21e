// SPDX-License-Identifier: MIT
// Needs: storage.
// An edit starts from the base and says so when it leaves a variation behind; a shape that shall be
// kept becomes the new base.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, kept, movedCount, obj, typeTarget, usable } from "./support/page.ts";
import { site } from "./support/site.ts";

const press = async (page: Page, name: string): Promise<void> => {
  await page.getByRole("button", { name, exact: true }).click();
  await idle(page);
};

async function slide(page: Page, name: string, value: string): Promise<void> {
  await page.getByRole("slider", { name, exact: true }).fill(value);
  await idle(page);
}

/** An edit and a variation of it; `value` of the first slider. */
async function vary(page: Page, value: string): Promise<void> {
  await typeTarget(page, "+80cm");
  await press(page, "Find variations");
  if (value !== "0") await slide(page, "Variation 1", value);
}

it("a link and a reload hold the new base", async () => {
  const page = await site.openVault();
  await vary(page, "-0.4");
  await press(page, "Continue from this shape");
  await typeTarget(page, "+30cm");
  const [edited, moved] = [await obj(page), await movedCount(page)];
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  await page.keyboard.press("Escape");
  const other = await site.open({}, new URL(link).hash);
  await expect.poll(() => other.getByText(/^Verified/).count()).toBe(1);
  expect([await obj(other), await movedCount(other)]).toEqual([edited, moved]);
  await other.context().close();
  await kept(page);
  await page.reload();
  await usable(page);
  await idle(page);
  expect([await obj(page), await movedCount(page)]).toEqual([edited, moved]);
  await page.context().close();
});
