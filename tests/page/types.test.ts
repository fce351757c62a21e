// SPDX-License-Identifier: MIT
// Panel types in the page: colours that lead to their panels, counted as the command line counts them, panels
// made more alike as it does, and packages with one drawing a type.
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { readObj } from "../browser/support/obj.ts";
import { downloaded, idle, obj, openFile, showTab, typeTarget } from "../browser/support/page.ts";
import { site } from "./support/site.ts";

const CLI = new URL("../../build/native/planish", import.meta.url).pathname;

let folder: string;

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), "planish-types-"));
});

afterAll(() => rmSync(folder, { recursive: true }));

const legend = (page: Page) => page.getByRole("group", { name: "Legend", exact: true });

/** "61 types of 196 panels" → 61 */
const count = async (page: Page): Promise<number> =>
  Number.parseInt(
    (await legend(page)
      .getByText(/types? of \d+ panels/)
      .textContent()) ?? "",
    10,
  );

/** What the command line finds in the design shown. */
async function byCommand(page: Page, words: string): Promise<{ types: number; sizes: number[] }> {
  writeFileSync(join(folder, "shown.obj"), await obj(page));
  const given = ["types", "shown.obj", ...words.split(" "), "--report", "r.json"];
  execFileSync(CLI, given, { cwd: folder });
  return JSON.parse(await readFile(join(folder, "r.json"), "utf8")).types;
}

it("colours the largest types, as many as the command line finds, before and after an edit", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Types");
  const before = await byCommand(page, "--within 0.5%");
  await expect.poll(() => count(page)).toBe(before.types);
  const first = legend(page).getByRole("button", { name: `T-0001 ${before.sizes[0]}` });
  await first.click();
  await page.getByText(/^Panel \d+ 4 corners/).waitFor();
  await typeTarget(page, "+40cm");
  const after = await byCommand(page, "--within 0.5%");
  expect(after.types).toBeGreaterThan(before.types);
  await expect.poll(() => count(page)).toBe(after.types);
  await legend(page)
    .getByRole("combobox", { name: /^Corners within/ })
    .selectOption("2 % of an edge");
  await legend(page).getByRole("checkbox", { name: "Turned over, too" }).check();
  const wider = await byCommand(page, "--within 2% --mirrored");
  expect(wider.types).toBeLessThan(after.types);
  await expect.poll(() => count(page)).toBe(wider.types);
  await page.context().close();
});

it("says how an edit and its variations change the number of types, once they were asked for", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await typeTarget(page, "+40cm");
  const note = page.getByText(/^\d+ types \(\d+ before\)$/);
  expect(await note.count()).toBe(0);
  await page.getByRole("button", { name: "Undo" }).click();
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Types");
  const before = await byCommand(page, "--within 0.5%");
  await expect.poll(() => count(page)).toBe(before.types);
  await page.getByRole("button", { name: "Redo" }).click();
  const after = await byCommand(page, "--within 0.5%");
  await page.getByText(`${after.types} types (${before.types} before)`, { exact: true }).waitFor();
  await page.getByRole("button", { name: "Find variations" }).click();
  const tiles = page.getByRole("list", { name: "Gallery of variations" }).getByRole("button");
  await expect
    .poll(async () => (await tiles.first().getAttribute("title")) ?? "", { timeout: 20_000 })
    .toMatch(new RegExp(`\\d+ panels to make again, \\d+ types? \\(${before.types} before\\)`));
  await page.context().close();
});

it("compares snapshots by their types, which nobody has to ask for first", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  const before = await byCommand(page, "--within 0.5%");
  const snapshot = async (): Promise<void> => {
    await showTab(page, "Explore");
    await page.getByRole("button", { name: "Take snapshot" }).click();
    await idle(page);
  };
  await snapshot();
  await typeTarget(page, "+40cm");
  await snapshot();
  const after = await byCommand(page, "--within 0.5%");
  expect(after.types).not.toBe(before.types);
  const table = page.getByRole("table", { name: "Comparison" });
  await page.getByRole("button", { name: "Compare", exact: true }).click();
  await table.waitFor();
  const heads = await table.locator("thead th").allTextContents();
  const place = heads.indexOf("Types");
  const cells = (): Promise<(string | undefined)[]> =>
    table
      .locator("tbody tr")
      .evaluateAll((rows, k) => rows.map((row) => row.children[k]?.textContent ?? ""), place);
  const words = [before, after].map(({ types }) => `${types} types (${before.types} before)`);
  await expect.poll(cells, { timeout: 20_000 }).toEqual(words);
  await page.context().close();
});

it("cuts one template a type with the bytes of the command line", async () => {
  const page = await site.open();
  writeFileSync(join(folder, "Roof.obj"), await obj(page));
  await page.getByRole("button", { name: "Export" }).click();
  await page.getByRole("button", { name: "Cutting package…" }).click();
  const dialog = page.getByRole("dialog", { name: "Cutting package" });
  await dialog.getByLabel("Joint between panels").fill("20");
  await dialog.getByLabel("Drawn").selectOption("One template a type");
  await dialog.getByText(/Not like this: one drawing a type needs to know/).waitFor();
  const save = dialog.getByRole("button", { name: "Save package" });
  expect(await save.isDisabled()).toBe(true);
  await dialog.getByLabel("Joints vary by up to").fill("14");
  await dialog.getByLabel("Panels may be turned over").check();
  await dialog.getByLabel("Sheet width").fill("6000");
  await dialog.getByLabel("Sheet height").fill("3000");
  await dialog.getByLabel("Labels with a QR code").uncheck();
  await dialog.getByText(/panels drawn as \d+ types/).waitFor();
  await dialog.getByText(/^T-0001, as it is drawn/).waitFor();
  const download = page.waitForEvent("download");
  await save.click();
  const bytes = await downloaded(await download);
  await dialog.getByText(/Saved: \d+ panels drawn as \d+ types/).waitFor();
  const options = "--joint 6:34 --mirrored --by type --sheet 6000x3000 --against Roof.obj";
  const given = ["panels", "Roof.obj", "-o", "cli.zip", ...options.split(" ")];
  execFileSync(CLI, given, { cwd: folder });
  expect(bytes.equals(await readFile(join(folder, "cli.zip")))).toBe(true);
  await page.context().close();
});

/** Makes the design more alike by these words of the legend; the command line's report of the same. */
async function makeAlike(page: Page, most: string, options: string): Promise<AlikeReport> {
  writeFileSync(join(folder, "given.obj"), await obj(page));
  const alike = legend(page).getByRole("group");
  await legend(page).getByText("Make more alike", { exact: true }).click();
  await alike.getByRole("combobox", { name: "Moves up to" }).selectOption("20 % of an edge");
  await alike.getByRole("checkbox", { name: "The boundary stays" }).uncheck();
  await alike.getByRole("textbox", { name: "Types at most" }).fill(most);
  await alike.getByRole("button", { name: "Find fewer types" }).click();
  await idle(page);
  const given = `project given.obj ${options} --move 20% -o alike.obj --report alike.json`;
  execFileSync(CLI, given.split(" "), { cwd: folder });
  return JSON.parse(await readFile(join(folder, "alike.json"), "utf8")).types;
}

interface AlikeReport {
  readonly before: number;
  readonly after: number;
}

async function expectShownAsMade(page: Page): Promise<void> {
  const [here, there] = [await obj(page), await readFile(join(folder, "alike.obj"), "utf8")];
  const [mine, theirs] = [readObj(here).points.flat(), readObj(there).points.flat()];
  expect(mine.length).toBe(theirs.length);
  const apart = mine.map((x, k) => Math.abs(x - (theirs[k] ?? Number.NaN)));
  expect(Math.max(...apart)).toBeLessThan(1e-8);
}

it("makes panels more alike as the command line does, as one step of the history", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 }, size: 10 });
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Types");
  const before = await byCommand(page, "--within 0.5%");
  await expect.poll(() => count(page)).toBe(before.types);
  const given = await obj(page);
  const types = await makeAlike(page, "", "--within 0.5%");
  expect(types.after).toBeLessThan(0.5 * types.before);
  await page
    .getByText(`${types.after} types in place of ${types.before}, corners within`)
    .waitFor();
  await expectShownAsMade(page);
  // The legend counts with a share of the mean edge of the new mesh.
  const now = await byCommand(page, "--within 0.5%");
  await expect.poll(() => count(page)).toBe(now.types);
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  expect(await obj(page)).toBe(given);
  await page.context().close();
});

it("stops at a number of types, and the legend counts with the fit that was found", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  const sample = "sample vault --size 8 -o vault.obj".split(" ");
  execFileSync(CLI, sample, { cwd: folder });
  await openFile(page, "vault.obj", await readFile(join(folder, "vault.obj")));
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Types");
  await expect.poll(() => count(page)).toBeGreaterThan(3);
  const types = await makeAlike(page, "3", "--types 3");
  expect(types.after).toBeLessThanOrEqual(3);
  await expectShownAsMade(page);
  await expect.poll(() => count(page)).toBe(types.after);
  await page.context().close();
});
