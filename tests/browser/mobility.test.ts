// SPDX-License-Identifier: MIT
// Needs: workers, axe.
// Where the mesh can move, as colours that fill in while the page goes on.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { expectClean } from "./support/axe.ts";
import { idle, movedCount, status, still } from "./support/page.ts";
import { site } from "./support/site.ts";

const colourBy = (page: Page, what: string) =>
  page.getByRole("combobox", { name: "Colour by" }).selectOption(what);

/** Points measured so far, of how many. */
async function progress(page: Page): Promise<readonly [number, number]> {
  const words = await page.getByText(/^\d+( of \d+)? points measured$/).innerText();
  const [measured = 0, all = measured] = words.match(/\d+/g)?.map(Number) ?? [];
  return [measured, all];
}
const measured = async (page: Page): Promise<number> => (await progress(page))[0];

/** How many it is in the end: what was being measured when it was stopped has been told and shown. */
async function lastMeasured(page: Page): Promise<number> {
  const worker = page.workers().find((one) => one.url().includes("mobility-worker"));
  if (!worker) throw new Error("nothing measures");
  // The worker answers after what it measures and, the second time, after the order to stop.
  for (let answer = 0; answer < 2; ++answer)
    await worker.evaluate(() => new Promise((resolve) => setTimeout(resolve)));
  await page.evaluate(
    () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
  );
  return measured(page);
}

it("a map of mobility fills in, is stopped and goes on, and the page answers meanwhile", async () => {
  const page = await site.openVault();
  await colourBy(page, "Mobility");
  await expect.poll(() => measured(page)).toBeGreaterThan(3);
  // What someone does meanwhile is done before the map is full: it is measured beside the page's thread.
  await page.getByRole("button", { name: "Add handle" }).click();
  await page.getByRole("button", { name: /^Select point/ }).waitFor();
  const [before, all] = await progress(page);
  expect(before).toBeLessThan(all);
  expect(all).toBe(441);
  await page.getByRole("button", { name: "Stop" }).click();
  const stopped = await lastMeasured(page);
  // It stays so while something else is done.
  await page.getByRole("button", { name: "Undo" }).click();
  await still(page);
  expect(await measured(page)).toBe(stopped);
  await page.getByRole("button", { name: "Go on" }).click();
  await expect.poll(() => measured(page)).toBeGreaterThan(stopped);
  // Another mesh is measured from its beginning, and one under other settings when asked.
  await page.getByRole("combobox", { name: "Sample" }).selectOption("hex");
  await idle(page);
  await expect.poll(async () => (await progress(page))[1]).not.toBe(441);
  await expect.poll(() => measured(page)).toBeGreaterThan(0);
  await page.getByRole("combobox", { name: "Boundary" }).selectOption("fixed");
  await idle(page);
  await page.getByRole("button", { name: "Stop" }).click();
  await page.getByRole("button", { name: "Measure again" }).click();
  await expect.poll(() => page.getByRole("button", { name: "Measure again" }).count()).toBe(0);
  await expect.poll(() => measured(page)).toBeGreaterThan(0);
  await page.context().close();
});

it("the best places open as edits that get there", async () => {
  const page = await site.open();
  await colourBy(page, "Mobility");
  const places = page.getByRole("list", { name: "Best places to change the shape" });
  await expect.poll(() => places.getByRole("button").count()).toBeGreaterThan(1);
  await page.getByRole("button", { name: "Stop" }).click();
  await lastMeasured(page);
  const first = places.getByRole("button").first();
  const words = await first.innerText();
  expect(words).toMatch(
    /^Point \d+ (up|down) [\d.,]+ (mm|m)\s+\d+ panels? again, folds up to [\d.]+°$/,
  );
  const vertex = /\d+/.exec(words)?.[0] ?? "";
  await expectClean(page, "mobility");
  await first.click();
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
  const handles = page.getByRole("table", { name: "Handles" });
  expect(await handles.getByRole("spinbutton", { name: "Z" }).count()).toBe(1);
  await handles.getByRole("button", { name: `Select point ${vertex}` }).waitFor();
  expect(await handles.getByText(/ short$/).count()).toBe(0);
  expect(await status(page)).not.toContain("cannot be reached");
  // One step of the history.
  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => movedCount(page)).toBe(0);
  await page.context().close();
});
