// SPDX-License-Identifier: MIT
// What an expert looks for: health of panels, sorting, how the solve went, settings behind a fold.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import {
  idle,
  movedCount,
  openAdvanced,
  openLastSolve,
  pickFile,
  showTab,
  still,
  typeTarget,
} from "../browser/support/page.ts";
import { hintedPoint, press } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

/** The cells of one column of the table Panels. */
async function column(page: Page, place: number): Promise<string[]> {
  const rows = page.getByRole("table", { name: "Panels" }).getByRole("row");
  const texts = await rows.evaluateAll(
    (all, k) => all.slice(1).map((row) => row.children[k]?.textContent ?? ""),
    place,
  );
  return texts;
}

const degrees = async (page: Page): Promise<number[]> =>
  (await column(page, 3)).map(Number.parseFloat);

it("lists panels by any figure, by keyboard, and says which must be made again", async () => {
  const page = await site.openVault({ viewport: { width: 1280, height: 900 } });
  await typeTarget(page, "+40cm");
  await expect.poll(() => page.getByText(/^[1-9]\d* panels must be made again/).count()).toBe(1);
  await showTab(page, "Check and make");
  const angle = page.getByRole("columnheader", { name: "Angle" });
  await angle.getByRole("button").focus();
  await page.keyboard.press("Enter");
  expect(await angle.getAttribute("aria-sort")).toBe("ascending");
  const smallest = await degrees(page);
  expect(smallest).toEqual(smallest.toSorted((a, b) => a - b));
  await page.keyboard.press("Enter");
  expect(await angle.getAttribute("aria-sort")).toBe("descending");
  const largest = await degrees(page);
  expect(largest).toEqual(largest.toSorted((a, b) => b - a));
  expect(Math.min(...largest)).toBeGreaterThan(Math.max(...smallest));
  // Choosing a panel brings it into view and says what it is.
  const handle = () => page.locator(".marker.handle").boundingBox();
  await still(page);
  const before = await handle();
  await page
    .getByRole("button", { name: /^Show panel \d+$/ })
    .first()
    .focus();
  await page.keyboard.press("Enter");
  await expect.poll(() => page.getByText(/^Panel \d+ 4 corners, /).count()).toBe(1);
  await still(page);
  await expect.poll(handle).not.toEqual(before);
  await page.context().close();
});

it("names every figure that it colours by, with a legend in mm or mm/m and a histogram", async () => {
  const page = await site.openVault({ viewport: { width: 1280, height: 900 } });
  await typeTarget(page, "+40cm");
  const moved = await movedCount(page);
  const histogram = page.getByRole("img", { name: /^Histogram: / });
  await expect
    .poll(() => histogram.getAttribute("aria-label"))
    .toBe(`Histogram: ${moved} points move, ${225 - moved} untouched`);
  const choose = (name: string) =>
    page.getByRole("combobox", { name: "Colour by" }).selectOption(name);
  expect(await page.getByText("Distance from the old surface").count()).toBe(1);
  expect(await page.getByText(/^−[\d.]+ m?m$/).count()).toBe(1);
  for (const [name, note] of [
    ["Slide", "Way along the old surface"],
    ["Displacement", "0 mm, untouched"],
    ["Shape", "Distance from the old surface"],
  ] as const) {
    await choose(name);
    await page.getByText(note).waitFor();
    expect(await histogram.getAttribute("aria-label")).toMatch(
      name === "Slide" ? /\d+ points slide, \d+ where they were$/ : `${moved} points move`,
    );
  }
  await choose("Fairness");
  await expect
    .poll(() => histogram.getAttribute("aria-label"))
    .toMatch(/\d+ points bend, \d+ smooth/);
  expect(await page.getByText("0 mm, smooth").count()).toBe(1);
  await choose("Planarity");
  await page.getByText(/^Worst panel flat \(< 0\.000001 mm\/m\)$/).waitFor();
  expect(await page.getByText(/0 panels out of flat, 196 flat/).count()).toBe(1);
  await choose("Panel health");
  await expect.poll(() => page.getByText(/^convex\s*196$/).count()).toBe(1);
  await page.context().close();
});

it("the histogram of displacement counts what a drag moves before it is let go", async () => {
  const page = await site.openVault();
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Displacement");
  const from = await hintedPoint(page);
  await press(page, from, { x: from.x + 15, y: from.y - 15 });
  const histogram = page.getByRole("img", { name: /^Histogram: / });
  await expect
    .poll(() => histogram.getAttribute("aria-label"))
    .toMatch(/^Histogram: [1-9]\d* points move, \d+ untouched$/);
  await page.mouse.up();
  await idle(page);
  expect(await histogram.getAttribute("aria-label")).toContain(
    `${await movedCount(page)} points move`,
  );
  await page.context().close();
});

it("says how far an edit changes the shape, and how far joints slide, where that is noticeable", async () => {
  const page = await site.openVault({ viewport: { width: 1280, height: 900 } });
  const said = page.getByText(/^(raised|lowered) [\d.]+ m?m, joints slide up to [\d.]+ m?m$/);
  expect(await said.count()).toBe(0);
  const metres = (words: string | null): number[] =>
    [...(words ?? "").matchAll(/([\d.]+) (m?m)/g)].map(
      ([, figure, unit]) => Number(figure) * (unit === "mm" ? 1e-3 : 1),
    );
  await typeTarget(page, "+40cm");
  const [raised = 0, slide = 0] = metres(await said.textContent());
  expect(await said.textContent()).toMatch(/^raised/);
  expect(raised).toBeGreaterThan(0.3);
  expect(slide).toBeGreaterThan(0.5 * raised);
  // The ends of the legend are the page's own, those in the status line the core's.
  const [end = 0] = metres(await page.getByText(/^−[\d.]+ m?m$/).textContent());
  expect(end).toBeCloseTo(raised, 3);
  await typeTarget(page, "+-80cm");
  await expect.poll(() => said.textContent()).toMatch(/^lowered/);
  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => said.textContent()).toMatch(/^raised/);
  await page.context().close();
});

it("shows how the solve went and changes it behind a fold", async () => {
  const page = await site.openVault({ viewport: { width: 1280, height: 900 } });
  await typeTarget(page, "+40cm");
  const before = await movedCount(page);
  await openLastSolve(page);
  expect(await page.getByRole("img", { name: /^Residual of \d+ steps/ }).count()).toBe(1);
  const fact = (name: string) => page.getByText(name, { exact: true }).locator("xpath=../dd");
  await expect.poll(() => fact("Independent ways left").count()).toBe(1);
  const [points = 0, equations = 0, rank = 0, ways = 0] = [
    ...((await fact("Points that may move").textContent()) ?? "").matchAll(/^\d+/g),
    ...((await fact("Flatness equations on them").textContent()) ?? "").matchAll(/\d+/g),
    ...((await fact("Independent ways left").textContent()) ?? "").matchAll(/\d+/g),
  ].map(Number);
  expect(points).toBe(before);
  expect(rank).toBeLessThanOrEqual(equations);
  expect(ways).toBe(3 * points - rank);
  await openAdvanced(page);
  await page.getByRole("combobox", { name: "Fairness" }).selectOption("Laplacian");
  await idle(page);
  await expect.poll(() => movedCount(page)).not.toBe(before);
  await page.getByRole("checkbox", { name: "Meet the targets exactly" }).check();
  await idle(page);
  await expect.poll(() => page.getByText("0 mm", { exact: true }).count()).toBeGreaterThan(0);
  await page.context().close();
});

it("says why a target is refused: how far short, which panels hold it; each can be seen", async () => {
  const page = await site.openVault({ viewport: { width: 1280, height: 900 } });
  await typeTarget(page, "+10cm");
  // Everything around the point is held: nothing can follow it.
  const why = page.getByRole("region", { name: "Why the target is not reached" });
  await idle(page);
  expect(await why.count()).toBe(0);
  await page.getByLabel("3D view").focus();
  for (const way of ["ArrowRight", "ArrowUp", "ArrowLeft", "ArrowLeft", "ArrowDown", "ArrowDown"])
    await page.keyboard.press(`Control+${way}`);
  for (const way of ["ArrowRight", "ArrowRight"]) await page.keyboard.press(`Control+${way}`);
  await page.getByRole("table", { name: "Handles" }).getByRole("rowheader").first().waitFor();
  await page.getByRole("button", { name: "Pin selected points" }).click();
  await idle(page);
  const first = page.getByRole("checkbox", { name: "Pinned" }).first();
  if (await first.isChecked()) await first.uncheck();
  await idle(page);
  await expect.poll(() => why.textContent()).toMatch(/^Panels allow (< )?[\d.]+ of \d+ mm here/);
  await openAdvanced(page);
  await page.getByRole("checkbox", { name: "Meet the targets exactly" }).check();
  await idle(page);
  await expect.poll(() => why.textContent()).toMatch(/some would not stay flat and sound/);
  const shows = why.getByRole("button", { name: /^Show panel \d+$/ });
  await expect.poll(() => shows.count()).toBeGreaterThan(0);
  const panel = await shows.first().textContent();
  await shows.first().click();
  expect(await page.getByText(/ corners, /).textContent()).toContain(`Panel ${panel}`);
  await page.context().close();
});

it("marks panels that cross themselves, in words too", async () => {
  const page = await site.openVault({ viewport: { width: 1280, height: 900 } });
  const bowTie = "v 0 0 0\nv 2 1 0\nv 2 0 0\nv 0 1 0\nv 3 0 0\nv 3 1 0\nf 1 2 3 4\nf 3 5 6 2\n";
  await pickFile(page, "bow.obj", bowTie);
  await page.getByRole("button", { name: /Start editing|Not now/ }).click();
  await expect.poll(() => page.getByText(/1 self-crossing/).count()).toBe(1);
  await showTab(page, "Check and make");
  expect((await column(page, 5))[0]).toBe("crosses itself");
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Panel health");
  await expect.poll(() => page.getByText("crosses itself (bow-tie)").count()).toBe(1);
  await page.context().close();
});
