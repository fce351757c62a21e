// SPDX-License-Identifier: MIT
// Where things are in the 3D view, by what the page itself says and shows.
import type { Page } from "playwright-core";

export interface Place {
  readonly x: number;
  readonly y: number;
}

/** Pixels from the tip of the first visit's sentence to its point. */
const TIP = 26;

/** The point that the first visit's sentence speaks of. */
export async function hintedPoint(page: Page): Promise<Place> {
  const sentence = page.getByText("Drag this point");
  await sentence.waitFor();
  const box = await sentence.boundingBox();
  if (!box) throw new Error("no sentence");
  return { x: box.x + box.width / 2, y: box.y + box.height + TIP };
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
