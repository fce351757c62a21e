// SPDX-License-Identifier: MIT
// Export → Cutting package…, Drawings…, IFC…: dialogs that say what they saved; their module comes when
// asked for, and writes the bytes of the command line.
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Locator, Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { downloaded, idle, obj, openFile, typeTarget } from "../browser/support/page.ts";
import { site } from "./support/site.ts";
import { setPace } from "./support/surroundings.ts";

const CLI = new URL("../../build/native/planish", import.meta.url).pathname;

let folder: string;

beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), "planish-shop-"));
});

afterAll(() => rmSync(folder, { recursive: true }));

async function openDialog(page: Page, name: string) {
  await page.getByRole("button", { name: "Export" }).click();
  await page.getByRole("button", { name }).click();
  return page.getByRole("dialog", { name: name.replace("…", "") });
}

async function saved(page: Page, dialog: Locator, button: string) {
  const download = page.waitForEvent("download");
  await dialog.getByRole("button", { name: button }).click();
  const file = await download;
  return { name: file.suggestedFilename(), bytes: await downloaded(file) };
}

/** As the page names the design: the command line takes the name of its file. */
const FILE = "Roof.obj";

/** Writes base.obj and the design. */
async function editVault(page: Page): Promise<void> {
  writeFileSync(join(folder, "base.obj"), await obj(page));
  await typeTarget(page, "+40cm");
  writeFileSync(join(folder, FILE), await obj(page));
}

const command = (words: readonly string[]) => execFileSync(CLI, words, { cwd: folder });

it("draws what is selected, plans and models with the bytes of the command line", async () => {
  const page = await site.open();
  await editVault(page);
  const ifc = await openDialog(page, "IFC…");
  await ifc.getByLabel("Plates of").selectOption({ index: 2 });
  await ifc.getByLabel("Thickness").fill("8");
  const model = await saved(page, ifc, "Save IFC");
  expect(model.name).toMatch(/\.ifc$/);
  const plates = [...model.bytes.toString().matchAll(/=IFCPLATE\('.{22}',\$,'P-(\d+)'/g)];
  expect(plates).toHaveLength(4); // the panels at the point that was moved
  const scope = plates.map(([, number]) => Number(number) - 1).join(",");
  const words = `-o cli.ifc --against base.obj --thickness 8 --scope ${scope}`;
  command(["panels", FILE, ...words.split(" ")]);
  expect(model.bytes.toString()).toBe(await readFile(join(folder, "cli.ifc"), "utf8"));
  await ifc.getByText(/4 panels drawn/).waitFor();
  await page.keyboard.press("Escape");

  const dialog = await openDialog(page, "Drawings…");
  await dialog.getByLabel("Section").selectOption("Across y, seen from the front");
  await dialog.getByLabel("Section at y").fill("3.25");
  await dialog.getByLabel("Axes and levels").fill("x=2:A, y=4:1, z=1.5:Eaves");
  const drawings = await saved(page, dialog, "Save drawings");
  expect(drawings.name).toMatch(/-drawings\.zip$/);
  const axes = ["x=2:A", "y=4:1", "z=1.5:Eaves"].flatMap((axis) => ["--axis", axis]);
  command(["drawings", FILE, "-o", "cli.zip", "--section", "y=3.25", ...axes]);
  expect(drawings.bytes.equals(await readFile(join(folder, "cli.zip")))).toBe(true);
  await dialog.getByText(/Drawn at 1 : \d+\./).waitFor();
  await page.context().close();
});

it("says what is wrong with a sheet of one length, and saves nothing", async () => {
  setPace("own"); // the press comes before the preview says so, too
  const page = await site.open();
  const dialog = await openDialog(page, "Cutting package…");
  await dialog.getByLabel("Sheet width").fill("6000");
  await dialog.getByRole("button", { name: "Save package" }).click();
  await dialog.getByText(/Not like this: sheet must be two lengths/).waitFor();
  const save = dialog.getByRole("button", { name: "Save package" });
  await expect.poll(() => save.isDisabled()).toBe(true);
  // Behind a dialog nobody reads it.
  expect(await page.getByRole("alert").count()).toBe(0);
  await dialog.getByLabel("Sheet height").fill("3000");
  await expect.poll(() => save.isDisabled()).toBe(false);
  await dialog.getByText(/^\d+ panels drawn/).waitFor();
  await page.context().close();
});

it("says before saving that a link is too long for a code", async () => {
  const page = await site.open();
  const said = page.getByText(/too long for a code: the labels will carry none/);
  const dialog = await openDialog(page, "Cutting package…");
  await dialog.getByText(/^\d+ panels drawn/).waitFor();
  expect(await said.count()).toBe(0);
  await page.keyboard.press("Escape");
  // A mesh that no sample gives: the link carries its coordinates.
  const larger = (await obj(page)).replace(/-?\d+\.\d+(e-?\d+)?/g, (x) => String(1.1 * Number(x)));
  await openFile(page, "larger.obj", larger);
  await idle(page);
  await openDialog(page, "Cutting package…");
  await said.waitFor();
  await dialog.getByLabel("Labels with a QR code").uncheck();
  await expect.poll(() => said.count()).toBe(0);
  await page.context().close();
});

/** The entries of an archive, by name. */
function unpacked(bytes: Buffer): Record<string, string> {
  writeFileSync(join(folder, "page.zip"), bytes);
  const script =
    "import json,sys,zipfile\nz=zipfile.ZipFile(sys.argv[1])\n" +
    "print(json.dumps({n:z.read(n).decode() for n in z.namelist()}))";
  const options = { cwd: folder, maxBuffer: 1e9 };
  return JSON.parse(execFileSync("python3", ["-c", script, "page.zip"], options).toString());
}

it("a package has the bytes of the command line, and says what must be made again", async () => {
  const page = await site.open();
  await editVault(page);
  const dialog = await openDialog(page, "Cutting package…");
  await dialog.getByLabel("Joint between panels").fill("6");
  await dialog.getByLabel("Sheet width").fill("6000");
  await dialog.getByLabel("Sheet height").fill("3000");
  await dialog.getByLabel("Text height").fill("15");
  await dialog.getByLabel("Drawings of").selectOption("What must be made again");
  const { name, bytes } = await saved(page, dialog, "Save package");
  expect(name).toMatch(/-package\.zip$/);
  const said = dialog.getByText(/panels drawn; \d+ to be cut again, \d+ with a new bevel only/);
  await said.waitFor();
  const words = (await said.textContent()) ?? "";
  const [, outline, bevel] = /(\d+) to be cut again, (\d+) with/.exec(words) ?? [];
  expect(Number(outline)).toBeGreaterThan(3);
  expect(Number(bevel)).toBeGreaterThan(3);
  const entries = unpacked(bytes);
  const { labels } = JSON.parse(entries["package.json"] ?? "");
  expect(labels.code).toBe(true);
  const options = "--against base.obj --gap 6 --sheet 6000x3000 --scope remake --text-height 15";
  const link = ["--link", labels.link];
  command(["panels", FILE, "-o", "cli.zip", ...options.split(" "), ...link]);
  expect(bytes.equals(await readFile(join(folder, "cli.zip")))).toBe(true);
  // The link on the labels opens the design, verified.
  const scanned = await site.open({}, new URL(labels.link).hash);
  await scanned
    .getByText(/verified/i)
    .first()
    .waitFor();
  await scanned.context().close();
  await page.context().close();
});
