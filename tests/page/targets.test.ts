// SPDX-License-Identifier: MIT
// What the page says of handles that are not where they were asked to be, against its own file.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { readObj } from "../browser/support/obj.ts";
import { exportAs, idle, openLastSolve, showTab, typeTarget } from "../browser/support/page.ts";
import { handleRows } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

const press = async (page: Page, name: string): Promise<void> => {
  await page.getByRole("button", { name, exact: true }).click();
  await idle(page);
};

/** Millimetres from the first handle's target to its point in the exported file. */
async function away(page: Page): Promise<number> {
  const { points } = readObj((await exportAs(page, "OBJ")).toString());
  await showTab(page, "Edit");
  const [row] = await handleRows(page);
  const at = points[row?.vertex ?? 0] ?? [];
  return 1000 * Math.hypot(...(row?.target ?? []).map((x, k) => x - (at[k] ?? Number.NaN)));
}

/** Millimetres that the row and the report give; the row is silent at 0. */
async function told(page: Page): Promise<{ row: number; report: number; words: string }> {
  const table = page.getByRole("table", { name: "Handles" });
  const said = await table
    .getByText(/^[\d.]+ mm (short|from the target in this variation)$/)
    .allTextContents();
  const [length = "0", , words = ""] = said[0]?.split(" ") ?? [];
  const report = await page
    .getByText("Furthest from a target now", { exact: true })
    .locator("xpath=following-sibling::dd")
    .textContent();
  return { row: Number(length), report: Number(report?.replace(" mm", "")), words };
}

async function expectTruth(page: Page, words: string): Promise<void> {
  const [real, said] = [await away(page), await told(page)];
  expect(said.words).toBe(words);
  expect(Math.abs(said.report - real)).toBeLessThanOrEqual(0.51);
  if (words) expect(Math.abs(said.row - real)).toBeLessThanOrEqual(0.51);
}

it("says how far a point stops short, and can do away with it", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+50mm");
  await openLastSolve(page);
  expect(await away(page)).toBeGreaterThan(1);
  await expectTruth(page, "short");
  await press(page, "Meet the targets exactly");
  await expectTruth(page, "");
  expect(await away(page)).toBeLessThan(0.001);
  expect(await page.getByRole("button", { name: "Meet the targets exactly" }).count()).toBe(0);
  await press(page, "Undo");
  await expectTruth(page, "short");
  await page.context().close();
});

it("speaks of the variation that is shown, not of the edit before it", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+80cm");
  await openLastSolve(page);
  await showTab(page, "Explore");
  await press(page, "Find variations");
  await expectTruth(page, "short");
  await showTab(page, "Explore");
  await page.getByRole("slider", { name: "Variation 1", exact: true }).fill("0.7");
  await idle(page);
  expect(await away(page)).toBeGreaterThan(20);
  await expectTruth(page, "from");
  expect(await page.getByRole("button", { name: "Meet the targets exactly" }).count()).toBe(0);
  await press(page, "Undo");
  await expectTruth(page, "short");
  await press(page, "Redo");
  await expectTruth(page, "from");
  await page.context().close();
});
