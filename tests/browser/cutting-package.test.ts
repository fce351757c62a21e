// SPDX-License-Identifier: MIT
// Export → Cutting package…: a dialog that says what it saved; its module comes when asked for.
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { obj, typeTarget } from "./support/page.ts";
import { site } from "./support/site.ts";

const CLI = new URL("../../build/native/planish", import.meta.url).pathname;

async function openDialog(page: Page) {
  await page.getByRole("button", { name: "Export" }).click();
  await page.getByRole("button", { name: "Cutting package…" }).click();
  return page.getByRole("dialog", { name: "Cutting package" });
}

it("saves the bytes of the command line, and says what must be made again", async () => {
  const page = await site.open();
  const folder = mkdtempSync(join(tmpdir(), "planish-shop-"));
  const requests: string[] = [];
  page.on("request", (request) => requests.push(request.url()));
  writeFileSync(join(folder, "base.obj"), await obj(page));
  await typeTarget(page, "+40cm");
  writeFileSync(join(folder, "vault.obj"), await obj(page));
  expect(requests.some((url) => url.includes("planish_shop"))).toBe(false);
  const dialog = await openDialog(page);
  await dialog.getByLabel("Joint between panels").fill("6");
  await dialog.getByLabel("Sheet width").fill("6000");
  await dialog.getByLabel("Sheet height").fill("3000");
  await dialog.getByLabel("Drawings of").selectOption("What must be made again");
  const download = page.waitForEvent("download");
  await dialog.getByRole("button", { name: "Save package" }).click();
  const saved = await download;
  expect(saved.suggestedFilename()).toMatch(/-package\.zip$/);
  const zip = await readFile(await saved.path());
  const said = dialog.getByText(/panels drawn; \d+ to be cut again, \d+ with a new bevel only/);
  await said.waitFor();
  const words = (await said.textContent()) ?? "";
  const [, outline, bevel] = /(\d+) to be cut again, (\d+) with/.exec(words) ?? [];
  expect(Number(outline)).toBeGreaterThan(3);
  expect(Number(bevel)).toBeGreaterThan(3);
  const options = "--against base.obj --gap 6 --sheet 6000x3000 --scope remake";
  execFileSync(CLI, `panels vault.obj -o cli.zip ${options}`.split(" "), { cwd: folder });
  const theirs = await readFile(join(folder, "cli.zip"));
  // The page knows the design's name, the command line its file's: everything else is the same.
  const unpacked = (bytes: Buffer, name: string): Record<string, string> => {
    writeFileSync(join(folder, name), bytes);
    const script =
      "import json,sys,zipfile,hashlib\nz=zipfile.ZipFile(sys.argv[1])\n" +
      "print(json.dumps({n:hashlib.sha256(z.read(n)).hexdigest() for n in z.namelist()}))";
    const text = execFileSync("python3", ["-c", script, name], { cwd: folder });
    return JSON.parse(text.toString());
  };
  const [ours, others] = [unpacked(zip, "page.zip"), unpacked(theirs, "cli.zip")];
  delete ours["package.json"];
  delete others["package.json"];
  expect(Object.keys(ours).length).toBeGreaterThan(Number(outline));
  expect(ours).toEqual(others);
  rmSync(folder, { recursive: true });
  await page.context().close();
});

it("says what is wrong with a sheet of one length, and saves nothing", async () => {
  const page = await site.open();
  const dialog = await openDialog(page);
  await dialog.getByLabel("Sheet width").fill("6000");
  await dialog.getByRole("button", { name: "Save package" }).click();
  await expect
    .poll(() => page.locator("[role=alert]").textContent())
    .toMatch(/sheet must be two lengths/);
  await page.context().close();
});
