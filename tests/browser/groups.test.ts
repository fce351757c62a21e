// SPDX-License-Identifier: MIT
// Needs: storage, axe.
// Groups: made from what is selected, there from an OBJ and back into one, locked, stiffened, hidden,
// coloured, kept by a reload and handed over.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { expectClean } from "./support/axe.ts";
import { idle, kept, movedCount, usable } from "./support/page.ts";
import { site } from "./support/site.ts";

const section = (page: Page) => page.getByRole("region", { name: "Groups" });

const names = (page: Page): Promise<string[]> =>
  section(page)
    .getByRole("textbox")
    .evaluateAll((all) => all.map((one) => (one as HTMLInputElement).value));

const press = (page: Page, name: string): Promise<void> =>
  section(page).getByRole("button", { name, exact: true }).click();

it("lock, stiffen, hide and colour what they hold, survive a reload and travel in a link", async () => {
  const page = await site.open({ permissions: ["clipboard-read", "clipboard-write"] });
  await page.getByRole("button", { name: "Add handle" }).click();
  await idle(page);
  const z = page.getByRole("table", { name: "Handles" }).getByRole("spinbutton", { name: "Z" });
  await z.last().fill("+400mm");
  await z.last().press("Enter");
  await idle(page);
  const free = await movedCount(page);
  // The ring around the handle: grown from it, without it.
  await page.keyboard.press("Control+k");
  await page.getByRole("combobox", { name: "Command" }).fill("Grow the selection");
  await page.keyboard.press("Enter");
  await press(page, "Group points");
  await section(page).getByRole("textbox", { name: "Name of Group 1" }).fill("Lantern");
  await page.keyboard.press("Enter");
  const will = section(page).getByRole("combobox", { name: "How willingly Lantern moves" });
  const largest = async (): Promise<string> =>
    (await page.getByRole("status").filter({ hasText: "points move" }).textContent()) ?? "";
  const before = await largest();
  await will.selectOption("hardly move");
  await idle(page);
  await expect.poll(largest).not.toBe(before);
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Groups");
  await page
    .getByRole("group", { name: "Legend" })
    .getByRole("button", { name: /^Lantern/ })
    .waitFor();
  await press(page, "Hide Lantern");
  await page.getByRole("region", { name: "Hidden panels" }).waitFor();
  await press(page, "Hide Lantern");
  await expectClean(page, "with a group");
  await press(page, "Lock Lantern");
  await idle(page);
  expect(
    await section(page).getByRole("button", { name: "Lock Lantern" }).getAttribute("aria-pressed"),
  ).toBe("true");
  await press(page, "Lock Lantern");
  await idle(page);
  expect(free).toBeGreaterThan(0);

  await kept(page);
  await page.reload();
  await usable(page);
  await expect.poll(() => names(page)).toEqual(["Lantern"]);
  expect(await will.inputValue()).toBe("30");

  await page.getByRole("button", { name: "Share", exact: true }).click();
  await page.getByRole("checkbox", { name: "1 group" }).waitFor();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  const other = await site.open({}, new URL(link).hash);
  await expect.poll(() => names(other)).toEqual(["Lantern"]);
  await other.context().close();
  await page.context().close();
});
