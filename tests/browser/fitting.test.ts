// SPDX-License-Identifier: MIT
// Needs: pixels.
// A fitted model is under nothing that lies over the view.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { exportAs, idle, openFile, still, typeTarget } from "./support/page.ts";
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

/** Left, right, top and bottom of what is dark in the view: of the model. */
async function extent(page: Page): Promise<readonly number[]> {
  const picture = readPng(await exportAs(page, "PNG"));
  const xs: number[] = [];
  const ys: number[] = [];
  for (let y = 0; y < picture.height; ++y)
    for (let x = 0; x < picture.width; ++x)
      if (Math.max(...picture.at(x, y)) < DARK) {
        xs.push(x);
        ys.push(y);
      }
  return [xs, ys].flatMap((of) => {
    const sorted = of.toSorted((a, b) => a - b);
    return [sorted[0] ?? Number.NaN, sorted.at(-1) ?? Number.NaN];
  });
}

/** 5 by 5 points in a row of panels `high` up at the far side; a little out of flat by `bump`. */
const sheet = (high: number, bump = 0): string => {
  const line = [0, 1, 2, 3, 4];
  const z = (x: number, y: number): number => (y * high) / 4 + (x === 2 && y === 2 ? bump : 0);
  const points = line.flatMap((y) => line.map((x) => `v ${x} ${y} ${z(x, y)}`));
  const corner = (x: number, y: number): number => 5 * y + x + 1;
  const panels = line.slice(1).flatMap((y) =>
    line.slice(1).map((x) => {
      const [a, b] = [corner(x - 1, y - 1), corner(x - 1, y)];
      return `f ${a} ${a + 1} ${b + 1} ${b}`;
    }),
  );
  return [...points, ...panels, ""].join("\n");
};

const startEditing = (page: Page): Promise<void> =>
  page.getByRole("button", { name: "Start editing" }).click();

it("a mesh with as many points as the one before is fitted all the same; one made flat is seen from where it was", async () => {
  const page = await site.open({ draws: true });
  await openFile(page, "steep.obj", sheet(9));
  await startEditing(page);
  const wanted = await extent(page);
  await openFile(page, "flat.obj", sheet(0));
  await startEditing(page);
  expect(await extent(page)).not.toEqual(wanted);
  await openFile(page, "steep.obj", sheet(9));
  await startEditing(page);
  expect(await extent(page)).toEqual(wanted);

  await openFile(page, "bumpy.obj", sheet(0, 0.01));
  await page.getByLabel("3D view").focus();
  for (let k = 0; k < 4; ++k) await page.keyboard.press("-");
  await still(page);
  const before = await extent(page);
  await page.getByRole("button", { name: "Planarise", exact: true }).click();
  await idle(page);
  await startEditing(page);
  const after = await extent(page);
  after.forEach((end, k) => {
    expect(Math.abs(end - (before[k] ?? Number.NaN))).toBeLessThan(4);
  });
  await page.context().close();
});

const view = (page: Page, name: string): Promise<void> =>
  page.getByRole("button", { name, exact: true }).click();

it("the legend and the views are beside the model, on desks and telephones", async () => {
  const page = await site.openVault({ draws: true, viewport: { width: 1120, height: 700 } });
  await still(page);
  expect(await edgesUnder(page, "Legend")).toBe(0);
  await typeTarget(page, "+40cm");
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Planarity");
  for (const [width, height] of [
    [1120, 700],
    [390, 844],
    [740, 360],
  ] as const) {
    await page.setViewportSize({ width, height });
    for (const name of ["Top", "Front", "Side", "Perspective", "Fit"]) {
      await view(page, name);
      await still(page);
      expect([name, width, await edgesUnder(page, "Legend")]).toEqual([name, width, 0]);
      expect([name, width, await edgesUnder(page, "Views")]).toEqual([name, width, 0]);
    }
  }
  // The picture can tell: nearer, the model is under them.
  const middle = await page.locator(".marker").first().boundingBox();
  if (!middle) throw new Error("no handle");
  await page.mouse.move(middle.x + middle.width / 2, middle.y + middle.height / 2);
  for (let k = 0; k < 20; ++k) await page.mouse.wheel(0, -120);
  await expect.poll(() => edgesUnder(page, "Legend")).toBeGreaterThan(0);
  await page.context().close();
});
