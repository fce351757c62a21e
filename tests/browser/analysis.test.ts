// SPDX-License-Identifier: MIT
// What an expert looks for: health of panels, sorting, how the solve went, settings behind a fold.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { idle, movedCount, openSite, type Site, typeTarget } from "./support/page.ts";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

let site: Site;
beforeAll(async () => {
  site = await openSite();
});
afterAll(() => site.close());

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
  const page = await site.open({ viewport: { width: 1280, height: 900 } });
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
  await page.context().close();
});

it("marks panels that cross themselves, in words too", async () => {
  const page = await site.open({ viewport: { width: 1280, height: 900 } });
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: "Open file" }).click();
  const bowTie = "v 0 0 0\nv 2 1 0\nv 2 0 0\nv 0 1 0\nv 3 0 0\nv 3 1 0\nf 1 2 3 4\nf 3 5 6 2\n";
  await (await chooser).setFiles({
    name: "bow.obj",
    mimeType: "text/plain",
    buffer: Buffer.from(bowTie),
  });
  await page.getByRole("button", { name: /Start editing|Leave as it is/ }).click();
  await expect.poll(() => page.getByText(/1 self-crossing/).count()).toBe(1);
  await page.getByRole("columnheader", { name: "Shape" }).getByRole("button").click();
  expect((await column(page, 5))[0]).toBe("crosses itself");
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Panel health");
  expect(await page.getByText("crosses itself (bow-tie)").count()).toBe(1);
  await page.context().close();
});

it("shows how the solve went and changes it behind a fold; axe finds nothing", async () => {
  for (const colorScheme of ["light", "dark"] as const) {
    const page = await site.open({ viewport: { width: 1280, height: 900 }, colorScheme });
    await typeTarget(page, "+40cm");
    const before = await movedCount(page);
    await page.getByText("Last solve", { exact: true }).click();
    expect(await page.getByRole("img", { name: /^Residual of \d+ steps/ }).count()).toBe(1);
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
