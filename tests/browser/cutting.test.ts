// SPDX-License-Identifier: MIT
// Needs: pixels.
// What a click would cut is drawn where the pointer is, and is gone with it.
import { expect, it } from "vitest";
import { idle } from "./support/page.ts";
import { readPng } from "./support/pixels.ts";
import { site } from "./support/site.ts";
import { viewBox } from "./support/view.ts";

it("the line of a strip is drawn through the quads before it is cut", async () => {
  const page = await site.openVault({ draws: true, reducedMotion: "reduce" });
  await page.getByRole("button", { name: "Top", exact: true }).click();
  await page.getByRole("button", { name: "Cut panels" }).click();
  await page
    .getByRole("region", { name: "Cut panels" })
    .getByText("Strip", { exact: true })
    .click();
  await idle(page);
  const { x, y, width, height } = await viewBox(page);
  /** Pixels of the line's own blue. */
  const drawn = async (): Promise<number> => {
    const clip = { x: x + width / 4, y: y + height / 4, width: width / 2, height: height / 2 };
    const picture = readPng(await page.screenshot({ clip }));
    let count = 0;
    for (let row = 0; row < picture.height; ++row)
      for (let column = 0; column < picture.width; ++column) {
        const [red, , blue] = picture.at(column, row);
        if (blue - red > 120) count += 1;
      }
    return count;
  };
  await page.mouse.move(x + 4, y + height / 2);
  await expect.poll(drawn).toBe(0);
  await page.mouse.move(x + width / 2 + 10, y + height / 2 + 6);
  // Some 3 pixels wide, through what is seen of the strip.
  await expect.poll(drawn).toBeGreaterThan(300);
  await page.mouse.move(x + 4, y + height / 2);
  await expect.poll(drawn).toBe(0);
  await page.context().close();
});
