// SPDX-License-Identifier: MIT
// What a visitor does and sees, in a browser or in a page without one (tests/page).
import { buffer } from "node:stream/consumers";
import type { Download, Locator, Page } from "playwright-core";
import { expect } from "vitest";

/** Waits until the page can be used. */
export const usable = (page: Page): Promise<void> =>
  expect.poll(() => status(page)).not.toContain("loading");

export const status = async (page: Page): Promise<string> =>
  (await page.getByRole("status").textContent()) ?? "";

export const movedCount = async (page: Page): Promise<number> =>
  Number(/(\d+) of \d+ points move/.exec(await status(page))?.[1] ?? Number.NaN);

/** Waits until nothing runs, and no part of the page that will run is being fetched. */
export const idle = (page: Page): Promise<void> =>
  expect
    .poll(async () => {
      const fetching = await page.locator("main").getAttribute("data-fetching");
      return fetching === "0" && page.getByRole("button", { name: "Cancel" }).isDisabled();
    })
    .toBe(true);

/** Waits until all that is to be kept has been written. */
export async function kept(page: Page): Promise<void> {
  await idle(page);
  await page.locator("main[data-unsaved=false]").waitFor();
}

/** Waits until the view shows what it will go on showing: no camera glides, shadows are cast. */
export async function still(page: Page): Promise<void> {
  await idle(page);
  await page.locator("canvas#view[data-still=true]").waitFor();
}

/** Brings one of the three tabs of the inspector into sight. */
export const showTab = (page: Page, name: "Edit" | "Explore" | "Check and make"): Promise<void> =>
  page.getByRole("tab", { name, exact: true }).click();

/** The chip of a kind of rules, which says how many there are: "Keep-outs 1". */
export const ruleChip = (page: Page, name: string): Locator =>
  page.getByRole("button", { name: new RegExp(`^${name}( \\d+)?$`) });

/** Brings the editor of a kind of rules into sight. */
export async function openRule(page: Page, name: string): Promise<void> {
  await showTab(page, "Edit");
  const chip = ruleChip(page, name);
  if ((await chip.getAttribute("aria-expanded")) !== "true") await chip.click();
}

/** Brings the section, the numbers and the named views into sight. */
export async function openViewOptions(page: Page): Promise<void> {
  const button = page.getByRole("button", { name: "View options", exact: true });
  if ((await button.getAttribute("aria-expanded")) !== "true") await button.click();
}

/** Unfolds what few need: there the raw weights are. */
export async function openAdvanced(page: Page): Promise<void> {
  await showTab(page, "Edit");
  await page.getByText("Advanced", { exact: true }).click();
  await page.getByRole("slider", { name: "Locality" }).waitFor();
}

/** Unfolds how the last solve went. */
export async function openLastSolve(page: Page): Promise<void> {
  await showTab(page, "Check and make");
  await page.getByText("Last solve", { exact: true }).click();
}

/** Adds a handle if there is none and moves it: "+40cm" raises it. */
export async function typeTarget(page: Page, z: string): Promise<void> {
  await showTab(page, "Edit");
  const field = page.getByRole("table", { name: "Handles" }).getByRole("spinbutton", { name: "Z" });
  if ((await field.count()) === 0) {
    await page.getByRole("button", { name: "Add handle" }).click();
    await idle(page);
  }
  await field.first().fill(z);
  await field.first().press("Enter");
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
}

type Press = (page: Page) => Promise<void>;
const openButton: Press = (page) => page.getByRole("button", { name: "Open file" }).click();

/** Picks a file, without waiting for what the page makes of it. */
export async function pickFile(
  page: Page,
  name: string,
  content: string | Buffer,
  press = openButton,
): Promise<void> {
  const chooser = page.waitForEvent("filechooser");
  // The page catches the chooser from its own thread, which lets a key or a click overtake: two answers of
  // that thread say that the order to catch it has been carried out.
  await page.evaluate(() => 0);
  await page.evaluate(() => 0);
  await press(page);
  const file = { name, mimeType: "application/octet-stream", buffer: Buffer.from(content) };
  await (await chooser).setFiles(file);
}

export async function openFile(page: Page, name: string, content: string | Buffer): Promise<void> {
  await pickFile(page, name, content);
  await idle(page);
}

/** The browser may run elsewhere: it hands over what it saved. */
export async function downloaded(file: Download): Promise<Buffer> {
  return buffer(await file.createReadStream());
}

export async function exportAs(
  page: Page,
  format: "OBJ" | "GLB" | "3DM" | "PLY" | "PNG" | "JSON",
): Promise<Buffer> {
  await page.getByRole("button", { name: "Export" }).click();
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: format, exact: true }).click();
  return downloaded(await download);
}

/** The design as it would be saved for other programs. */
export const obj = async (page: Page): Promise<string> => (await exportAs(page, "OBJ")).toString();
