// SPDX-License-Identifier: MIT
// A fitted model is under nothing that lies over the view.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { typeTarget } from "./support/page.ts";
import { readPng } from "./support/pixels.ts";
import { site } from "./support/site.ts";

/** Of the panels' edges: darker than a shadow. */
const DARK = 110;

/** Dark pixels of the model under a group of the view's, which is hidden for the picture. */
async function edgesUnder(page: Page, name: "Legend" | "Views"): Promise<number> {
  const group = page.getByRole("group", { name, exact: true });
  const clip = await group.boundingBox();
  if (!clip) throw new Error(`no ${name}`);
  const show = (opacity: string): Promise<void> =>
    group.evaluate((element, value) => {
      element.style.opacity = value;
    }, opacity);
  await show("0");
  const picture = readPng(await page.screenshot({ clip }));
  await show("");
  let dark = 0;
  for (let y = 0; y < picture.height; ++y)
    for (let x = 0; x < picture.width; ++x) if (Math.max(...picture.at(x, y)) < DARK) dark += 1;
  return dark;
}

const view = (page: Page, name: string): Promise<void> =>
  page.getByRole("button", { name, exact: true }).click();

for (const [width, height] of [
  [1120, 700],
  [390, 844],
  [740, 360],
] as const)
  it(`the legend and the views are beside the model at ${width} × ${height}`, async () => {
    const page = await site.open({ viewport: { width, height } });
    await page.waitForTimeout(500);
    const colours = page.getByRole("combobox", { name: "Colour by" });
    expect(await edgesUnder(page, "Legend")).toBe(0);
    await typeTarget(page, "+40cm");
    await colours.selectOption("Planarity");
    for (const name of ["Top", "Front", "Side", "Perspective", "Fit"]) {
      await view(page, name);
      await page.waitForTimeout(500);
      expect([name, await edgesUnder(page, "Legend")]).toEqual([name, 0]);
      expect([name, await edgesUnder(page, "Views")]).toEqual([name, 0]);
    }
    // The picture can tell: nearer, the model is under them.
    await page.getByLabel("3D view").focus();
    for (let k = 0; k < 8; ++k) await page.keyboard.press("+");
    await expect.poll(() => edgesUnder(page, "Legend")).toBeGreaterThan(0);
    await page.context().close();
  });
