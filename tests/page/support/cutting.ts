// SPDX-License-Identifier: MIT
// The page's tool that cuts panels, as tests use it.
import type { Page } from "playwright-core";
import { expect } from "vitest";
import { flatRoof } from "../../browser/support/faults.ts";
import { readObj } from "../../browser/support/obj.ts";
import { exportAs, idle, obj, openFile, still } from "../../browser/support/page.ts";
import { type Place, viewBox } from "../../browser/support/view.ts";
import { site } from "./site.ts";

export const ROOMY = { viewport: { width: 1440, height: 900 } };

export const tool = (page: Page) => page.getByRole("button", { name: "Cut panels" });

export const strip = (page: Page) => page.getByRole("region", { name: "Cut panels" });

export const kind = (page: Page, name: string) =>
  strip(page).getByRole("button", { name, exact: true }).click();

export const field = (page: Page) => strip(page).getByRole("textbox").first();

export const listed = async (page: Page): Promise<string[]> =>
  Promise.all(
    (await page.getByRole("list", { name: "Cuts made" }).getByRole("listitem").all()).map(
      async (item) => ((await item.textContent()) ?? "").replace(/(Remove|Remove from here)$/, ""),
    ),
  );

export async function start(page: Page): Promise<void> {
  await tool(page).click();
  await strip(page).waitFor();
  await idle(page);
}

export async function typed(page: Page, name: string, numbers: string): Promise<void> {
  await kind(page, name);
  await field(page).fill(numbers);
  await field(page).press("Enter");
  await idle(page);
}

export const panels = async (page: Page): Promise<number> => readObj(await obj(page)).faces.length;

export const cutsOf = async (page: Page): Promise<string[]> =>
  JSON.parse((await exportAs(page, "JSON")).toString()).cuts ?? [];

/** Seen from above, where panel k of a flat roof of n × n panels can be counted. */
export async function roofFromAbove(
  n: number,
): Promise<{ page: Page; at: (x: number, y: number) => Place }> {
  const page = await site.openVault(ROOMY);
  await openFile(page, "roof.obj", flatRoof(n));
  await page.getByRole("button", { name: "Start editing" }).click();
  await page.getByRole("button", { name: "Top" }).click();
  await still(page);
  const marks = async (): Promise<Place[]> => {
    const all = await page.locator(".marker.selected:not([hidden])").all();
    return Promise.all(
      all.map(async (one) => {
        const box = await one.boundingBox();
        if (!box) throw new Error("no mark");
        return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
      }),
    );
  };
  await page.getByRole("button", { name: "Select in a box" }).click();
  const view = await viewBox(page);
  await page.mouse.move(view.x + 1, view.y + 1);
  await page.mouse.down();
  await page.mouse.move(view.x + view.width - 1, view.y + view.height - 1, { steps: 3 });
  await page.mouse.up();
  await expect.poll(async () => (await marks()).length).toBe((n + 1) ** 2);
  await still(page);
  const seen = await marks();
  await page.keyboard.press("Escape");
  await expect.poll(async () => (await marks()).length).toBe(0);
  const [xs, ys] = [seen.map(({ x }) => x), seen.map(({ y }) => y)];
  const [left, right] = [Math.min(...xs), Math.max(...xs)];
  const [top, bottom] = [Math.min(...ys), Math.max(...ys)];
  // Points of the roof are numbered along x, then along y.
  const at = (x: number, y: number): Place => ({
    x: left + ((right - left) * x) / n,
    y: bottom - ((bottom - top) * y) / n,
  });
  const offGrid = seen.map((mark, k) => {
    const { x, y } = at(k % (n + 1), Math.floor(k / (n + 1)));
    return Math.hypot(mark.x - x, mark.y - y);
  });
  expect(Math.max(...offGrid), "pixels between a mark and where it is from above").toBeLessThan(2);
  return { page, at };
}
