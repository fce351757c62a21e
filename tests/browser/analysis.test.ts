// SPDX-License-Identifier: MIT
// Needs: pixels, axe, layout.
// What an expert looks for: health of panels, sorting, how the solve went, settings behind a fold.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, movedCount, pickFile, still, typeTarget } from "./support/page.ts";
import { site } from "./support/site.ts";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

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
  const page = await site.openVault({ draws: true, viewport: { width: 1280, height: 900 } });
  await typeTarget(page, "+40cm");
  await expect.poll(() => page.getByText(/^[1-9]\d* panels must be made again/).count()).toBe(1);
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
  const view = page.getByLabel("3D view");
  const before = await view.screenshot();
  await page
    .getByRole("button", { name: /^Show panel \d+$/ })
    .first()
    .focus();
  await page.keyboard.press("Enter");
  await expect.poll(() => page.getByText(/^Panel \d+ 4 corners, /).count()).toBe(1);
  await still(page);
  expect((await view.screenshot()).equals(before)).toBe(false);
  await page.context().close();
});

it("colours by every figure, with a legend in mm or mm/m and a histogram", async () => {
  const page = await site.openVault({ draws: true, viewport: { width: 1280, height: 900 } });
  await typeTarget(page, "+40cm");
  const moved = await movedCount(page);
  const histogram = page.getByRole("img", { name: /^Histogram: / });
  await expect
    .poll(() => histogram.getAttribute("aria-label"))
    .toBe(`Histogram: ${moved} points move, ${441 - moved} untouched`);
  const choose = (name: string) =>
    page.getByRole("combobox", { name: "Colour by" }).selectOption(name);
  const view = page.getByLabel("3D view");
  const seen = [await view.screenshot()];
  await choose("Fairness");
  await expect
    .poll(() => histogram.getAttribute("aria-label"))
    .toMatch(/\d+ points bend, \d+ smooth/);
  expect(await page.getByText("0 mm, smooth").count()).toBe(1);
  seen.push(await view.screenshot());
  await choose("Planarity");
  await page.getByText(/^Worst panel flat \(< 0\.000001 mm\/m\)$/).waitFor();
  expect(await page.getByText(/0 panels out of flat, 400 flat/).count()).toBe(1);
  seen.push(await view.screenshot());
  await choose("Panel health");
  await expect.poll(() => page.getByText(/^convex\s*400$/).count()).toBe(1);
  const pictures = new Set(seen.map((picture) => picture.toString("base64")));
  expect(pictures.size).toBe(3);
  await page.context().close();
});

/** A quad 1 m long whose last corner is `by` metres out of the plane, after a flat one. */
const bent = (by: number): string =>
  `v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 ${by}\nf 1 2 3 4\nf 2 5 6 3\n`;

it("the scale of planarity grows by decades to hold the worst panel, and leads to it", async () => {
  const page = await site.openVault({ viewport: { width: 1280, height: 900 } });
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Planarity");
  const named = async (): Promise<string[]> => {
    const legend = page.getByRole("group", { name: "Legend", exact: true });
    const shown = await legend
      .getByText(/^(0\.0*1|10*)$/)
      .evaluateAll((all) =>
        all.map((tick) => ({ text: tick.textContent ?? "", box: tick.getBoundingClientRect() })),
      );
    shown.slice(1).forEach(({ box }, k) => {
      expect(box.left - (shown[k]?.box.right ?? Number.NaN)).toBeGreaterThan(4);
    });
    return shown.map(({ text }) => text);
  };
  await expect.poll(named).toEqual(["0.001", "0.1", "10"]);
  const worst = page.getByRole("button", { name: /^Worst panel / });
  expect(await worst.count()).toBe(0);
  for (const [by, ticks] of [
    [0.01, ["0.001", "0.1", "10"]],
    [0.1, ["0.0001", "0.1", "100"]],
    [0.4, ["0.001", "1", "1000"]],
  ] as const) {
    await pickFile(page, "bent.obj", bent(by));
    await page.getByRole("button", { name: "Leave as it is" }).click();
    await expect.poll(named).toEqual(ticks);
  }
  await page.setViewportSize({ width: 390, height: 844 });
  await expect.poll(named).toEqual(["0.001", "1", "1000"]);
  await page.setViewportSize({ width: 1280, height: 900 });
  await worst.focus();
  await page.keyboard.press("Enter");
  await expect.poll(() => page.getByText(/^Panel 1 4 corners, /).count()).toBe(1);
  await page.context().close();
});

it("shows how the solve went and changes it behind a fold; axe finds nothing", async () => {
  for (const colorScheme of ["light", "dark"] as const) {
    const page = await site.openVault({
      draws: true,
      viewport: { width: 1280, height: 900 },
      colorScheme,
    });
    await typeTarget(page, "+40cm");
    const before = await movedCount(page);
    await page.getByText("Last solve", { exact: true }).click();
    expect(await page.getByRole("img", { name: /^Residual of \d+ steps/ }).count()).toBe(1);
    const fact = (name: string) => page.getByText(name, { exact: true }).locator("xpath=../dd");
    await expect.poll(() => fact("Ways left to move them").count()).toBe(1);
    const [points = 0, equations = 0, rank = 0, ways = 0] = [
      ...((await fact("Points that may move").textContent()) ?? "").matchAll(/^\d+/g),
      ...((await fact("Flatness equations on them").textContent()) ?? "").matchAll(/\d+/g),
      ...((await fact("Ways left to move them").textContent()) ?? "").matchAll(/\d+/g),
    ].map(Number);
    expect(points).toBe(before);
    expect(rank).toBeLessThanOrEqual(equations);
    expect(ways).toBe(3 * points - rank);
    await page.getByText("Advanced", { exact: true }).click();
    await page.getByRole("combobox", { name: "Fairness" }).selectOption("Laplacian");
    await idle(page);
    await expect.poll(() => movedCount(page)).not.toBe(before);
    await page.getByRole("checkbox", { name: "Meet the targets exactly" }).check();
    await idle(page);
    await expect.poll(() => page.getByText("0 mm", { exact: true }).count()).toBeGreaterThan(0);
    await page.getByRole("combobox", { name: "Colour by" }).selectOption("Panel health");
    const violations = (await page.evaluate(
      `${AXE}; axe.run(document).then((result) => result.violations)`,
    )) as { id: string; nodes: { html: string }[] }[];
    expect(violations.map(({ id, nodes }) => `${id} ${nodes[0]?.html}`)).toEqual([]);
    if (process.env.PLANISH_PICTURES)
      await page.screenshot({
        path: `${process.env.PLANISH_PICTURES}/analysis-${colorScheme}.png`,
      });
    await page.getByRole("button", { name: "Undo" }).click();
    await idle(page);
    await page.context().close();
  }
});
