// SPDX-License-Identifier: MIT
// Needs: pixels, network.
// Check and make, Second layer: the design at a distance is drawn with it; what makes it comes when asked for.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { layOut } from "./support/layer.ts";
import { exportAs, idle, status } from "./support/page.ts";
import { readPng } from "./support/pixels.ts";
import { site } from "./support/site.ts";

/** Pixels as blue as the layer's edges are, which its panels are not. */
async function blueOf(page: Page): Promise<number> {
  const { width, height, at } = readPng(await exportAs(page, "PNG"));
  let count = 0;
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const [red, , blue] = at(x, y);
      if (blue - red > 125) ++count;
    }
  return count;
}

it("a second layer is drawn with its edges, by a module that comes when asked for", async () => {
  const page = await site.open({ draws: true });
  const requests: string[] = [];
  page.on("request", (request) => requests.push(request.url()));
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Dome");
  await idle(page);
  const picture = async () => (await exportAs(page, "PNG")).toString("base64");
  const before = await picture();
  expect(requests.join()).not.toContain("planish_documents");
  await layOut(page, "0.25", /^Panels lie at 250 mm everywhere\.$/);
  expect(requests.join()).toContain("planish_documents");
  await expect.poll(async () => (await picture()) !== before).toBe(true);
  await expect.poll(() => blueOf(page)).toBeGreaterThan(1000);
  await page.context().close();
});

it("of a design without the offset that is asked for the section says what it misses", async () => {
  const page = await site.open();
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Vault");
  await idle(page);
  const refusal =
    /^No second layer: points at one distance have no parallel edges: panel \d+ misses a circle by [\d.]+ deg\. Make panels circular \(Advanced\) makes it so\.$/;
  await layOut(page, "0.2", refusal, "Points at the distance");
  expect(await page.getByRole("region", { name: "Second layer" }).count()).toBe(0);
  await layOut(page, "-0.2", /^Edges are parallel; points lie at -\d+ mm to -\d+ mm\./);
  await page.getByRole("region", { name: "Second layer" }).waitFor();
  // It goes with its mesh.
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Dome");
  await expect.poll(() => page.getByRole("region", { name: "Second layer" }).count()).toBe(0);
  expect(await status(page)).not.toContain("offset");
  await page.context().close();
});
