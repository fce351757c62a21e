// SPDX-License-Identifier: MIT
// Snapshots held against each other by figures that the page says elsewhere, too; one of them is gone on with.
import type { Locator, Page } from "playwright-core";
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
import { handleRows } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

async function snapshot(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Snapshot", exact: true }).click();
  await idle(page);
}

async function compare(page: Page): Promise<Locator> {
  await showTab(page, "Explore");
  await page.getByRole("button", { name: "Compare", exact: true }).click();
  return page.getByRole("table", { name: "Comparison" });
}

/** What the legend has at the end of its ramp. */
async function legendEnd(page: Page, colours: string): Promise<string> {
  await page.getByRole("combobox", { name: "Colour by" }).selectOption(colours);
  const ends = page.getByRole("group", { name: "Legend", exact: true }).locator(".legend-ends");
  await expect.poll(() => ends.textContent()).toMatch(/[1-9]\d* m?m$/);
  return (await ends.locator("span").last().textContent()) ?? "";
}

async function column(table: Locator, title: string): Promise<string[]> {
  const place = (await table.locator("thead th").allTextContents()).indexOf(title);
  return table
    .locator("tbody tr")
    .evaluateAll((rows, k) => rows.map((row) => row.children[k]?.textContent ?? ""), place);
}

/** Millimetres from the only handle to its target. */
async function shortOf(page: Page): Promise<number> {
  const [row] = await handleRows(page);
  const { points } = readObj(await obj(page));
  const at = points[row?.vertex ?? -1] ?? [];
  return 1000 * Math.hypot(...at.map((x, k) => x - (row?.target[k] ?? 0)));
}

it("the table has the largest slide, what handles are short of, and the bend, as the page has them", async () => {
  const page = await site.openVault();
  await snapshot(page);
  await typeTarget(page, "+3m");
  const short = await shortOf(page);
  expect(short).toBeGreaterThan(10);
  const [slide, bend] = [await legendEnd(page, "Slide"), await legendEnd(page, "Fairness")];
  await snapshot(page);
  const table = await compare(page);
  await expect.poll(() => column(table, "Largest slide")).toEqual(["0 mm", slide]);
  expect(await column(table, "Largest bend")).toEqual(["0 mm", bend]);
  const [none, some = ""] = await column(table, "Handle from its target");
  expect(none).toBe("–");
  expect(Math.abs(Number.parseFloat(some) - short)).toBeLessThan(1);
  await page.context().close();
});

it("bends by different operators are not held against each other", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+40cm");
  await snapshot(page);
  await openAdvanced(page);
  await page.getByRole("combobox", { name: "Fairness" }).selectOption("Laplacian");
  await idle(page);
  const table = await compare(page);
  await expect.poll(() => column(table, "Largest bend")).toHaveLength(2);
  await expect.poll(async () => (await column(table, "Largest bend"))[1]).not.toBe("…");
  expect(await column(table, "Largest bend")).toEqual([expect.stringMatching(/[1-9]/), "–"]);
  await page.context().close();
});

it("Adopt makes that design the one to go on with, as one step, and closes the table", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+40cm");
  const first = { moved: await movedCount(page), shape: await obj(page) };
  await snapshot(page);
  await typeTarget(page, "+20cm");
  await snapshot(page);
  const second = await obj(page);
  expect(second).not.toBe(first.shape);
  const table = await compare(page);
  await table.getByRole("button", { name: "Adopt Snapshot 1" }).click();
  await idle(page);
  expect(await page.getByRole("dialog").count()).toBe(0);
  expect(await movedCount(page)).toBe(first.moved);
  expect(await obj(page)).toBe(first.shape);
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  expect(await obj(page)).toBe(second);
  await page.context().close();
});
