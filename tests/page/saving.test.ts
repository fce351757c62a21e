// SPDX-License-Identifier: MIT
// What is saved beside the mesh: the design as JSON, which opens again, and the panels as a table.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { flatRoof } from "../browser/support/faults.ts";
import {
  downloaded,
  idle,
  movedCount,
  obj,
  openFile,
  showTab,
  typeTarget,
} from "../browser/support/page.ts";
import { site } from "./support/site.ts";

interface Saved {
  readonly name: string;
  readonly text: string;
}

async function saved(page: Page, press: () => Promise<void>): Promise<Saved> {
  const download = page.waitForEvent("download");
  await press();
  const file = await download;
  return { name: file.suggestedFilename(), text: (await downloaded(file)).toString() };
}

const saveDesign = (page: Page): Promise<Saved> =>
  saved(page, async () => {
    await page.getByRole("button", { name: "Export" }).click();
    await page.getByRole("button", { name: "JSON", exact: true }).click();
  });

it.each(["sample", "file"])(
  "a design of a %s opens again, verified, to the last bit",
  async (kind) => {
    const page = await site.openVault();
    if (kind === "file") {
      await openFile(page, "roof.obj", flatRoof(6));
      await page.getByRole("button", { name: "Start editing" }).click();
    }
    await typeTarget(page, "+40cm");
    const [moved, edited] = [await movedCount(page), await obj(page)];
    const { name, text } = await saveDesign(page);
    expect(name).toBe(kind === "file" ? "roof-design.json" : "vault-design.json");
    const other = await site.open(); // no link, whose own "Verified" would answer at once
    await openFile(other, name, text);
    await other.getByText(/^Verified:/).waitFor({ timeout: 60_000 });
    await idle(other);
    expect(await movedCount(other)).toBe(moved);
    expect(await obj(other)).toBe(edited);
    await other.context().close();
    await page.context().close();
  },
);

it("nothing that is exported has the name of the opened file, nor is a design's design", async () => {
  const page = await site.openVault();
  for (const opened of ["roof.obj", "roof-design.obj", "Roof-design-2.OBJ"]) {
    await openFile(page, opened, flatRoof(6));
    await page.getByRole("button", { name: "Start editing" }).click();
    for (const format of ["OBJ", "PLY", "GLB", "PNG", "JSON"]) {
      const { name } = await saved(page, async () => {
        await page.getByRole("button", { name: "Export" }).click();
        await page.getByRole("button", { name: format, exact: true }).click();
      });
      expect(name).not.toBe(opened.toLowerCase());
      const again = { "roof-design.obj": "-2", "Roof-design-2.OBJ": "-3" }[opened] ?? "";
      const count = format === "OBJ" ? again : "";
      expect(name).toBe(`roof-design${count}.${format.toLowerCase()}`);
    }
  }
  await page.context().close();
});

it("the table of panels is saved with a line for every panel", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+40cm");
  await showTab(page, "Check and make");
  const button = page.getByRole("button", { name: "Save CSV" });
  await button.waitFor();
  const sentence = page.getByText(/panels? must be made again after this edit/);
  await expect.poll(() => sentence.textContent()).not.toMatch(/^0 /);
  const { name, text } = await saved(page, () => button.click());
  expect(name).toBe("vault-panels.csv");
  const [head, ...lines] = text.trimEnd().split("\r\n");
  const columns = head?.split(",") ?? [];
  expect(columns).toContain("must_be_made_again");
  expect(lines.length).toBe(196);
  expect(lines.every((line) => line.split(",").length === columns.length)).toBe(true);
  const ending = (word: string): number => lines.filter((line) => line.endsWith(`,${word}`)).length;
  const [outline, bevel] = [ending("yes"), ending("bevel")];
  expect(bevel).toBeGreaterThan(0);
  expect(outline + bevel + ending("no")).toBe(lines.length);
  expect(await sentence.textContent()).toMatch(
    new RegExp(`^${outline + bevel} panels .*, ${bevel} of them with a new bevel only`),
  );
  await page.context().close();
});
