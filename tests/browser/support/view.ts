// SPDX-License-Identifier: MIT
// Where things are in the 3D view, by what the page itself says and shows.
import type { Locator, Page } from "playwright-core";
import { expect } from "vitest";
import { still } from "./page.ts";

export interface Place {
  readonly x: number;
  readonly y: number;
}

/** Pixels from the tip of the first visit's sentence to its point. */
const TIP = 26;

/** Where a mark over the view is, once the view is still: a mark is put in its place with a picture. */
export async function middleOf(page: Page, mark: Locator): Promise<Place> {
  await still(page);
  const box = await mark.boundingBox();
  if (!box) throw new Error("no mark");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** The point that the first key of the view takes, which is the one in the middle; none stays chosen. */
async function middlePoint(page: Page): Promise<Place> {
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("ArrowUp");
  const marker = page.locator(".marker:not([hidden])").first();
  await marker.waitFor();
  // It is put in its place with the next picture.
  const place = async (): Promise<string> =>
    (await marker.evaluate((element: HTMLElement) => element.style.transform)) ?? "";
  await still(page);
  await expect.poll(place).not.toBe("");
  const middle = await middleOf(page, marker);
  await page.keyboard.press("Escape");
  return middle;
}

/** The point that the first visit's sentence speaks of, or on a page without it would speak of. */
export async function hintedPoint(page: Page): Promise<Place> {
  const sentence = page.getByText("Drag this point");
  const visit = !page.url().includes("#v");
  if (!visit || !(await sentence.isVisible())) return middlePoint(page);
  await sentence.waitFor();
  const box = await sentence.boundingBox();
  if (!box) throw new Error("no sentence");
  const below = (await page.locator(".hint").getAttribute("data-side")) === "below";
  return { x: box.x + box.width / 2, y: below ? box.y - TIP : box.y + box.height + TIP };
}

export async function viewBox(
  page: Page,
): Promise<{ x: number; y: number; width: number; height: number }> {
  const box = await page.getByLabel("3D view").boundingBox();
  if (!box) throw new Error("no 3D view");
  return box;
}

/** Presses at `from` and moves on in steps; the button stays down. */
export async function press(page: Page, from: Place, ...to: readonly Place[]): Promise<void> {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  let at = from;
  for (const next of to) {
    for (let k = 1; k <= 5; ++k) {
      await page.mouse.move(at.x + ((next.x - at.x) * k) / 5, at.y + ((next.y - at.y) * k) / 5);
    }
    at = next;
  }
}

export interface HandleRow {
  readonly vertex: number;
  readonly target: readonly number[];
  readonly pinned: boolean;
}

/** The Handles table as it reads; rows that stand for many points are left out. */
export async function handleRows(page: Page): Promise<HandleRow[]> {
  const rows = page
    .getByRole("table", { name: "Handles" })
    .locator("tbody")
    .getByRole("row")
    .filter({ has: page.getByRole("checkbox", { name: "Pinned" }) });
  const found: HandleRow[] = [];
  for (const row of await rows.all()) {
    const fields = await row.getByRole("spinbutton").all();
    const values = await Promise.all(fields.map((f) => f.getAttribute("aria-valuenow")));
    found.push({
      vertex: Number(await row.getByRole("rowheader").textContent()),
      target: values.map(Number),
      pinned: await row.getByRole("checkbox", { name: "Pinned" }).isChecked(),
    });
  }
  return found;
}
