// SPDX-License-Identifier: MIT
// Needs: pixels.
// What the panels are coloured by is seen: every figure has a picture of its own, stripes and glass look like
// themselves, and where there are no figures the ground is shaded.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { openViewOptions, still, typeTarget } from "./support/page.ts";
import { type Picture, readPng } from "./support/pixels.ts";
import { site } from "./support/site.ts";

const picture = (page: Page): Promise<Buffer> => page.getByLabel("3D view").screenshot();

const colourBy = async (page: Page, what: string): Promise<void> => {
  await page.getByRole("combobox", { name: "Colour by" }).selectOption(what);
  await still(page);
};

/** Shares of dark and of light grey in the middle of the view. */
async function shares(page: Page): Promise<readonly number[]> {
  const seen = readPng(await picture(page));
  const [x, y] = [seen.width >> 1, seen.height >> 1];
  const middle = Array.from({ length: 200 * 200 }, (_, k) =>
    seen.at(x - 100 + (k % 200), y - 50 + Math.floor(k / 200)),
  );
  const grey = middle.filter((rgb) => Math.max(...rgb) - Math.min(...rgb) < 24);
  const dark = grey.filter(([red]) => red < 60).length / middle.length;
  return [dark, grey.filter(([red]) => red > 180).length / middle.length];
}

/** Pixels of bare paper that are darker than in `plain`. */
function shaded(plain: Picture, now: Picture): number {
  const [paper] = plain.at(plain.width - 4, plain.height >> 1);
  let count = 0;
  for (let x = 0; x < now.width; ++x)
    for (let y = 80; y < now.height; ++y)
      if (plain.at(x, y)[0] === paper && now.at(x, y)[0] < paper - 6) ++count;
  return count;
}

it("by figures, by what must be made again, as stripes and as glass; without, with shade", async () => {
  const page = await site.openVault({ draws: true, viewport: { width: 1280, height: 900 } });
  await typeTarget(page, "+40cm");
  await still(page);
  const seen = [await picture(page)];
  await colourBy(page, "Fairness");
  seen.push(await picture(page));
  await page.getByRole("button", { name: /^\d+ panels to make again$/ }).press("Enter");
  await still(page);
  seen.push(await picture(page));
  await colourBy(page, "Planarity");
  const planarity = await picture(page);
  seen.push(planarity);
  expect(new Set(seen.map((one) => one.toString("base64"))).size).toBe(4);

  const plain = readPng(planarity);
  const shade = async (): Promise<number> => shaded(plain, readPng(await picture(page)));
  expect(await shade()).toBeLessThan(20);
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Nothing");
  await expect.poll(shade).toBeGreaterThan(400);

  // Most of it is stripes, dark and light.
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Reflection lines");
  await expect.poll(async () => Math.min(...(await shares(page)))).toBeGreaterThan(0.2);
  // What lies behind glass shows through: no place is as dark as a stripe, and none is one colour.
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Glass");
  await expect.poll(async () => (await shares(page))[0]).toBeLessThan(0.02);
  // A section cuts away what lies before it.
  await still(page);
  const whole = await picture(page);
  await openViewOptions(page);
  await page.getByRole("combobox", { name: "Cut the view" }).selectOption("across X");
  await expect.poll(async () => (await picture(page)).equals(whole)).toBe(false);
  await page.context().close();
});
