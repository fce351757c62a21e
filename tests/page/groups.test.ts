// SPDX-License-Identifier: MIT
// Groups: made from what is selected, there from an OBJ and back into one, locked, stiffened, hidden,
// coloured, kept by a reload and handed over.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, movedCount, obj, openFile } from "../browser/support/page.ts";
import { site } from "./support/site.ts";

/** Six flat quads in two rows, the first row in a group, and one of both rows in another. */
const GRID = `
${Array.from({ length: 12 }, (_, k) => `v ${k % 4} ${Math.floor(k / 4)} 0`).join("\n")}
g West wing
f 1 2 6 5
f 2 3 7 6
g West
f 3 4 8 7
g
f 5 6 10 9
f 6 7 11 10
g Doors
f 7 8 12 11
`;

const section = (page: Page) => page.getByRole("region", { name: "Groups" });

const names = (page: Page): Promise<string[]> =>
  section(page)
    .getByRole("textbox")
    .evaluateAll((all) => all.map((one) => (one as HTMLInputElement).value));

const press = (page: Page, name: string): Promise<void> =>
  section(page).getByRole("button", { name, exact: true }).click();

it("those of an OBJ are there, and go back into one with those made here", async () => {
  const page = await site.open();
  await openFile(page, "wings.obj", GRID);
  await expect.poll(() => names(page)).toEqual(["West", "wing", "Doors"]);
  expect(await section(page).getByText("3 panels").count()).toBe(1);
  const untouched = await obj(page);
  expect(untouched).toMatch(/g West wing\nf 1 2 6 5\nf 2 3 7 6\ng West\nf 3 4 8 7\ng *\nf 5/);
  await press(page, "Select Doors");
  await press(page, "Group panels");
  await section(page).getByRole("textbox", { name: "Name of Group 1" }).fill("New doors");
  await page.keyboard.press("Enter");
  await press(page, "Delete wing");
  expect(await names(page)).toEqual(["West", "Doors", "New doors"]);
  expect(await obj(page)).toMatch(
    /g West\nf 1 2 6 5\n.*\n.*\ng *\nf 5.*\n.*\ng Doors New_doors\nf 7/,
  );
  await page.context().close();
});

it("lock, stiffen, hide and colour what they hold, and travel in a link", async () => {
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
  await press(page, "Lock Lantern");
  await idle(page);
  expect(
    await section(page).getByRole("button", { name: "Lock Lantern" }).getAttribute("aria-pressed"),
  ).toBe("true");
  await press(page, "Lock Lantern");
  await idle(page);
  expect(free).toBeGreaterThan(0);
  expect(await will.inputValue()).toBe("30");
  await page.getByRole("button", { name: "Share", exact: true }).click();
  await page.getByRole("checkbox", { name: "1 group" }).waitFor();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  const other = await site.open({}, new URL(link).hash);
  await expect.poll(() => names(other)).toEqual(["Lantern"]);
  await other.context().close();
  await page.context().close();
});
