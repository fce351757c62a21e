// SPDX-License-Identifier: MIT
// A view without what is there for the hand, for pictures and meetings.
import type { Page } from "playwright-core";
import { expect, it, vi } from "vitest";
import { Shell } from "../../web/src/scene/shell.ts";
import { idle, openRule, openViewOptions, typeTarget } from "../browser/support/page.ts";
import { handleRows, hintedPoint, middleOf, press } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

const clean = (page: Page) => page.getByLabel("Hide marks, arrows and the reach");

/** How many of each kind lie over the model. */
const overModel = (page: Page): Promise<number[]> =>
  Promise.all(
    [".marker", ".pull", ".reach-knob:not([hidden])", ".hint:not([hidden])"].map((kind) =>
      page.locator(kind).count(),
    ),
  );

/** Whether something can be taken hold of at a place over the model. */
async function holdsAt(page: Page, x: number, y: number): Promise<boolean> {
  await page.mouse.move(x, y);
  return page.getByLabel("3D view").evaluate((view) => view.style.cursor === "grab");
}

it("hides the first visit's point and sentence, and shows them again", async () => {
  const page = await site.open();
  await hintedPoint(page);
  await openViewOptions(page);
  await clean(page).check();
  await expect.poll(() => overModel(page)).toEqual([0, 0, 0, 0]);
  await clean(page).uncheck();
  await expect.poll(() => overModel(page)).toEqual([1, 0, 0, 1]);
  await page.context().close();
});

it("hides marks, pulls, arrows and the reach; points are moved as before, and all commands end it", async () => {
  const page = await site.open();
  await typeTarget(page, "+60cm");
  expect(await overModel(page)).toEqual([1, 1, 1, 0]);
  const { x, y } = await middleOf(page, page.locator(".marker.handle"));
  // Half along the arrow upwards, off every point.
  const arrow = [x, y - 34] as const;
  await expect.poll(() => holdsAt(page, ...arrow)).toBe(true);
  await openViewOptions(page);
  await clean(page).check();
  await expect.poll(() => overModel(page)).toEqual([0, 0, 0, 0]);
  expect(await holdsAt(page, ...arrow)).toBe(false);
  const target = async (): Promise<number> => (await handleRows(page))[0]?.target[2] ?? 0;
  const before = await target();
  await press(page, { x, y }, { x, y: y - 30 });
  await page.mouse.up();
  await idle(page);
  expect(await target()).toBeGreaterThan(before + 0.1);
  expect(await overModel(page)).toEqual([0, 0, 0, 0]);
  await page.keyboard.press("Control+k");
  await page.getByRole("combobox", { name: "Command" }).fill("clean view");
  await page.keyboard.press("Enter");
  await expect.poll(() => overModel(page)).toEqual([1, 1, 1, 0]);
  expect(await clean(page).isChecked()).toBe(false);
  await page.context().close();
});

it("hides the outline of a chosen panel with its figure, and those of panels at a limit", async () => {
  const [outline, limits] = [
    vi.spyOn(Shell.prototype, "outlinePanel"),
    vi.spyOn(Shell.prototype, "markLimits"),
  ];
  const page = await site.openVault();
  await typeTarget(page, "+1m");
  await openRule(page, "Limits");
  const field = page.getByRole("textbox", { name: "Folds up to", exact: true });
  await field.fill("12");
  await field.press("Enter");
  await idle(page);
  await page.getByRole("button", { name: "Show panels at the limit on folds" }).click();
  const figure = page.locator(".panel-figure:not([hidden])");
  await expect.poll(() => figure.count()).toBe(1);
  expect(outline.mock.lastCall?.[0]).toBeGreaterThanOrEqual(0);
  await openViewOptions(page);
  await clean(page).check();
  await expect.poll(() => figure.count()).toBe(0);
  expect([outline.mock.lastCall?.[0], limits.mock.lastCall?.[0]]).toEqual([null, []]);
  await clean(page).uncheck();
  await expect.poll(() => figure.count()).toBe(1);
  expect(outline.mock.lastCall?.[0]).toBeGreaterThanOrEqual(0);
  expect(limits.mock.lastCall?.[0].length).toBeGreaterThan(0);
  await page.context().close();
});
