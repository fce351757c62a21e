// SPDX-License-Identifier: MIT
// What is selected is what was clicked, and the arrows stand where the selected point is.
import { expect, it } from "vitest";
import { openFile, showTab, still } from "../browser/support/page.ts";
import { viewBox } from "../browser/support/view.ts";
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
