// SPDX-License-Identifier: MIT
// Needs: pixels.
// Snapshots held against each other: side by side or swiped, one camera, a table, the difference in colour.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, movedCount, showTab, typeTarget } from "./support/page.ts";
import { readPng, steady } from "./support/pixels.ts";
import { site } from "./support/site.ts";

async function snapshot(page: Page): Promise<number> {
  await showTab(page, "Explore");
  await page.getByRole("button", { name: "Take snapshot" }).click();
  await idle(page);
  return movedCount(page);
}

/** How many pixels of a picture are blue, as displaced panels are. */
function bluePixels(png: Buffer): number {
  const picture = readPng(png);
  let count = 0;
  for (let x = 0; x < picture.width; x += 2) {
    for (let y = 0; y < picture.height; y += 2) {
      const [red, , blue] = picture.at(x, y);
      if (blue > red + 60) count += 1;
    }
  }
  return count;
}

it("compares snapshots by a table, by one camera, and by the difference in colour", async () => {
  const page = await site.open({ draws: true, viewport: { width: 1280, height: 900 } });
  const open = page.getByRole("button", { name: "Compare", exact: true });
  expect(await open.count()).toBe(0);
  const moved = [await snapshot(page)];
  await typeTarget(page, "+40cm");
  moved.push(await snapshot(page));
  await showTab(page, "Edit");
  await page.getByRole("slider", { name: "Reach" }).fill("3");
  await idle(page);
  moved.push(await snapshot(page));
  expect(new Set(moved).size).toBe(3);

  await open.click();
  const table = page.getByRole("table", { name: "Comparison" });
  const column = (place: number) =>
    table
      .locator("tbody tr")
      .evaluateAll((rows, k) => rows.map((row) => row.children[k]?.textContent), place);
  await expect.poll(() => column(1)).toEqual(moved.map(String));
  expect(await column(3)).toEqual(["0", "0", "0"]);
  for (const place of [4, 5])
    for (const cell of await column(place)) expect(cell).toMatch(/^[\d.]+°$/);
  for (const cell of await column(6)) expect(cell).toMatch(/^[\d.]+ m²$/);
  const [untouched = 0, ...edited] = (await column(2)).map(Number);
  expect(untouched).toBe(0);
  for (const again of edited) expect(again).toBeGreaterThan(10);

  // The event of an earlier closing may come now: what is open stays.
  await page.getByRole("dialog").dispatchEvent("close");
  await idle(page);
  expect(await column(1)).toEqual(moved.map(String));

  // The first differs from nothing, the others from it; turning one turns all.
  const views = page.locator(".compare-view canvas");
  expect(await views.count()).toBe(3);
  const pictures = async (): Promise<Buffer[]> =>
    Promise.all((await views.all()).map((view) => view.screenshot()));
  const before = await steady(pictures);
  const [first = 0, second = 0] = before.map(bluePixels);
  expect(first).toBe(0);
  expect(second).toBeGreaterThan(200);
  const box = await views.nth(1).boundingBox();
  if (!box) throw new Error("no view");
  await page.mouse.move(box.x + box.width / 2, box.y + box.height - 20);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 80, box.y + box.height - 20, { steps: 4 });
  await page.mouse.up();
  (await steady(pictures)).forEach((picture, k) => {
    expect(picture.equals(before[k] ?? picture)).toBe(false);
  });

  await page.getByRole("combobox", { name: "Layout" }).selectOption("Swipe");
  expect(await views.count()).toBe(2);
  await page.getByRole("slider", { name: "Swipe" }).fill("0.2");
  await page.getByRole("button", { name: "Close" }).last().click();
  await expect.poll(() => page.getByRole("dialog").count()).toBe(0);
  expect(await movedCount(page)).toBe(moved.at(-1));
  await page.context().close();
});
