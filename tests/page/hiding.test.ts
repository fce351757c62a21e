// SPDX-License-Identifier: MIT
// Panels are hidden in the view alone: nothing of them is seen or hit there, and the design keeps them.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, obj, openFile, still } from "../browser/support/page.ts";
import { hintedPoint, press } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

const ROOMY = { viewport: { width: 1440, height: 900 } };

const note = (page: Page) => page.getByRole("region", { name: "Hidden panels" });

const tool = (page: Page, name: string) =>
  page.getByRole("toolbar", { name: "Drag tools" }).getByRole("button", { name });

const figure = (page: Page) => page.getByText(/^Panel \d+ \d corners/);

it("by keys and by buttons; what is hidden is not hit, and all of it comes back", async () => {
  const page = await site.openVault(ROOMY);
  const whole = await obj(page);
  await page.getByRole("button", { name: "Top", exact: true }).click();
  const above = await hintedPoint(page);
  // The middle of the panel to the upper right of the point: half an edge from it, each way.
  await page.mouse.click(above.x, above.y);
  await page.keyboard.press("ArrowRight");
  const half = async (): Promise<number> => {
    const box = await page.locator(".marker.selected:not([hidden])").first().boundingBox();
    return box ? (box.x + box.width / 2 - above.x) / 2 : 0;
  };
  await expect.poll(half).toBeGreaterThan(8);
  const beside = { x: above.x + (await half()), y: above.y - (await half()) };
  await page.keyboard.press("Escape");
  await page.mouse.click(beside.x, beside.y);
  await expect.poll(() => figure(page).count()).toBe(1);
  await page.keyboard.press("h");
  await note(page).waitFor();
  expect(await note(page).textContent()).toContain("1 panel hidden in the view");
  await expect.poll(() => figure(page).count()).toBe(0);
  await page.mouse.click(beside.x, beside.y);
  await still(page);
  expect(await figure(page).count()).toBe(0);
  await page.keyboard.press("Shift+H");
  await expect.poll(() => note(page).count()).toBe(0);
  await page.mouse.click(beside.x, beside.y);
  await expect.poll(() => figure(page).count()).toBe(1);
  await tool(page, "Hide the selected panels").click();
  await expect.poll(() => note(page).textContent()).toContain("1 panel hidden in the view");
  expect(await tool(page, "Hide the selected panels").isDisabled()).toBe(true);
  await note(page).getByRole("button", { name: "Show all" }).click();

  // Several points: their panels alone are shown, and only points of them are selected by a box.
  await page.keyboard.press("Escape");
  await page.mouse.click(above.x, above.y);
  await page.keyboard.press("Control+ArrowRight");
  const strip = page.getByRole("toolbar", { name: "Selected points" });
  await strip.getByRole("button", { name: "Isolate" }).click();
  expect(await note(page).textContent()).toContain("190 panels hidden in the view");
  await page.getByRole("button", { name: "Select in a box" }).click();
  await press(page, { x: above.x - 200, y: above.y - 200 }, { x: above.x + 200, y: above.y + 200 });
  await page.mouse.up();
  await expect.poll(() => strip.textContent()).toMatch(/^12 points/);
  // Nothing of the design is gone.
  expect(await obj(page)).toBe(whole);
  await note(page).getByRole("button", { name: "Show all" }).click();
  await expect.poll(() => note(page).count()).toBe(0);
  await page.context().close();
});

it("an edit moves what is hidden, too, and another mesh is shown whole", async () => {
  const page = await site.openVault(ROOMY);
  const at = await hintedPoint(page);
  await page.mouse.click(at.x, at.y);
  await tool(page, "Show only the selected panels").click();
  await note(page).waitFor();
  expect(await note(page).textContent()).toContain("192 panels hidden in the view");
  await press(page, at, { x: at.x, y: at.y - 40 });
  await page.mouse.up();
  await idle(page);
  const edited = await obj(page);
  await page.keyboard.press("Shift+H");
  expect(await obj(page)).toBe(edited);
  await page.keyboard.press("i");
  await note(page).waitFor();
  await openFile(page, "quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  await expect.poll(() => note(page).count()).toBe(0);
  await page.context().close();
});
