// SPDX-License-Identifier: MIT
// What is selected is what was clicked, and the arrows stand where the selected point is.
import { expect, it } from "vitest";
import { openFile, showTab, still } from "../browser/support/page.ts";
import { hintedPoint, viewBox } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

/** A closed box of 6 by 4 by 3, its normals outwards. */
const BOX = `v 0 0 0\nv 6 0 0\nv 6 4 0\nv 0 4 0\nv 0 0 3\nv 6 0 3\nv 6 4 3\nv 0 4 3
f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n`;

it("a panel chosen in the table can be seen: a click on it in the view selects it", async () => {
  const page = await site.openVault();
  await openFile(page, "box.obj", BOX);
  await page.getByRole("button", { name: "Start editing" }).click();
  await showTab(page, "Check and make");
  const { x, y, width, height } = await viewBox(page);
  const figure = page.getByText(/^Panel \d+ 4 corners/);
  for (const panel of [0, 1, 2, 3, 4, 5]) {
    await page.getByRole("button", { name: `Show panel ${panel}`, exact: true }).click();
    await expect.poll(() => figure.textContent()).toContain(`Panel ${panel} `);
    await still(page);
    await page.getByLabel("3D view").press("Escape");
    await expect.poll(() => figure.count()).toBe(0);
    // The camera's axis is in the middle of what the tools leave free.
    await page.mouse.click(x + width / 2, y + height / 2 + 26);
    await expect.poll(() => figure.textContent()).toContain(`Panel ${panel} `);
  }
  await page.context().close();
});

it("a clicked panel says its figure, and the camera stays", async () => {
  const page = await site.openVault({ viewport: { width: 900, height: 640 } });
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("2");
  await still(page);
  for (let k = 0; k < 8; ++k) await page.keyboard.press("+");
  const point = await hintedPoint(page);
  // From above and near enough, the middle of a panel lies right of a point and below it.
  for (let k = 20; k < 90 && (await page.getByText(/ corners, /).count()) === 0; k += 7) {
    await page.mouse.click(point.x + k, point.y + k);
    await still(page); // what says the figure comes with the first click
  }
  expect(await page.getByText(/ corners, /).textContent()).toMatch(
    /4 corners, flat \(< 0\.000001 mm\/m\)/,
  );
  expect(await hintedPoint(page)).toEqual(point);
  await page.keyboard.press("Escape");
  expect(await page.getByText(/ corners, /).count()).toBe(0);
  await page.context().close();
});
