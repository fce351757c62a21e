// SPDX-License-Identifier: MIT
// The palette: everything the page can be told, by a few letters, with keys and by touch.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, movedCount, showTab, typeTarget } from "../browser/support/page.ts";
import { site } from "./support/site.ts";

const field = (page: Page) => page.getByRole("combobox", { name: "Command" });

const options = (page: Page) => page.getByRole("listbox", { name: "Commands" }).getByRole("option");

const chosen = (page: Page) =>
  page
    .getByRole("listbox", { name: "Commands" })
    .getByRole("option", { selected: true })
    .textContent();

async function openPalette(page: Page): Promise<void> {
  await page.keyboard.press("Control+k");
  await expect
    .poll(() => field(page).evaluate((element) => element === document.activeElement))
    .toBe(true);
}

it("opens by a key, from a field too, finds, runs, and gives the focus back", async () => {
  const page = await site.open();
  await typeTarget(page, "+40cm");
  const z = page.getByRole("spinbutton", { name: "Z" }).first();
  await z.focus();
  await openPalette(page);
  const all = await options(page).count();
  await page.keyboard.type("un");
  expect(await options(page).count()).toBeLessThan(all);
  expect(await chosen(page)).toContain("Undo");
  await page.keyboard.press("Enter");
  await idle(page);
  expect(await page.getByRole("dialog").count()).toBe(0);
  expect(await movedCount(page)).toBe(0);

  await page.getByLabel("3D view").focus();
  await openPalette(page);
  await page.keyboard.press("Escape");
  expect(await page.getByRole("dialog").count()).toBe(0);
  expect(await page.getByLabel("3D view").evaluate((e) => e === document.activeElement)).toBe(true);
  await page.context().close();
});

it("arrows go through the list and around; what cannot run says why and stays", async () => {
  const page = await site.open();
  await openPalette(page);
  const first = await chosen(page);
  await page.keyboard.press("ArrowUp");
  const last = await chosen(page);
  expect(last).not.toBe(first);
  await page.keyboard.press("ArrowDown");
  expect(await chosen(page)).toBe(first);
  await page.keyboard.type("find var");
  expect(await chosen(page)).toContain("move a point first");
  await page.keyboard.press("Enter");
  expect(await field(page).isVisible()).toBe(true);
  await page.keyboard.press("Control+a");
  await page.keyboard.type("qqq");
  await page.getByText("No command has these letters.").waitFor();
  expect(await options(page).count()).toBe(0);
  await page.context().close();
});

it("buttons and Help say the keys of the same table; Make exact says what is exact", async () => {
  const page = await site.open();
  const title = (name: string) =>
    page.getByRole("button", { name, exact: true }).getAttribute("title");
  expect(await title("Undo")).toBe("Undo (Ctrl Z): There is nothing to undo.");
  expect(await title("Top")).toBe("Top (2)");
  await page.getByRole("button", { name: "Help" }).click();
  await page.getByText("all commands: type a few letters of one").waitFor();
  await page.keyboard.press("Escape");
  await showTab(page, "Check and make");
  await page.getByRole("button", { name: "Make exact" }).click();
  // Where it is read aloud.
  await page
    .locator("[aria-live=polite]")
    .getByText("Already exact: every panel is flat.")
    .waitFor();
  await page.context().close();
});
