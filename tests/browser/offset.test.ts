// SPDX-License-Identifier: MIT
// Needs: pixels, network.
// Check and make, Second layer: the design at a distance is drawn with it; what makes it comes when asked for.
import { expect, it } from "vitest";
import { layOut } from "./support/layer.ts";
import { exportAs, idle, status } from "./support/page.ts";
import { site } from "./support/site.ts";

it("a second layer is drawn, by a module that comes when asked for", async () => {
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
