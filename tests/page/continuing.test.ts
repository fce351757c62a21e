// SPDX-License-Identifier: MIT
// An edit starts from the base and says so when it leaves a variation behind; a shape that shall be
// kept becomes the new base.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { readObj } from "../browser/support/obj.ts";
import {
  idle,
  movedCount,
  obj,
  openAdvanced,
  showTab,
  typeTarget,
} from "../browser/support/page.ts";
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

/** How often it can be read. */
const leftBehind = (page: Page): Promise<number> =>
  page
    .getByText(/^The variation was left behind/)
    .filter({ visible: true })
    .count();

it("the shape becomes the base: its own bits, no handles, one step back", async () => {
  const page = await site.openVault();
  await vary(page, "0.6");
  const varied = await obj(page);
  await press(page, "Continue from this shape");
  await page.getByText(/^This shape is the new start/).waitFor();
  expect(await obj(page)).toBe(varied);
  expect(await movedCount(page)).toBe(0);
  const table = page.getByRole("table", { name: "Handles" });
  expect(await table.getByRole("spinbutton").count()).toBe(0);
  expect(await page.getByRole("slider", { name: /^Variation/ }).count()).toBe(0);
  // What the next edit does not move keeps the bits of the shape that it started from.
  await typeTarget(page, "+20cm");
  const [before, after] = [readObj(varied).lines, readObj(await obj(page)).lines];
  const moved = await movedCount(page);
  expect(after.filter((line, v) => line !== before[v]).length).toBe(moved);
  for (let k = 0; k < 3; ++k) await press(page, "Undo");
  expect(await obj(page)).toBe(varied);
  await showTab(page, "Explore");
  const first = page.getByRole("slider", { name: "Variation 1", exact: true });
  expect(await first.inputValue()).toBe("0.6");
  await page.context().close();
});

it("an edit says that it leaves a variation behind, and only then", async () => {
  const page = await site.openVault();
  await openAdvanced(page);
  await vary(page, "0");
  await showTab(page, "Edit");
  await slide(page, "Locality", "2");
  expect(await leftBehind(page)).toBe(0);
  await press(page, "Find variations");
  await slide(page, "Variation 1", "0.5");
  const varied = await obj(page);
  await showTab(page, "Edit");
  await slide(page, "Locality", "1.5");
  expect(await leftBehind(page)).toBe(1);
  await press(page, "Undo");
  expect(await leftBehind(page)).toBe(0);
  expect(await obj(page)).toBe(varied);
  await typeTarget(page, "+5cm");
  expect(await leftBehind(page)).toBe(1);
  await page.context().close();
});

it("a link holds the new base", async () => {
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
  await page.context().close();
});
