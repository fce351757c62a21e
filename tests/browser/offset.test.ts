// SPDX-License-Identifier: MIT
// Needs: pixels, network.
// Check and make, Second layer: the design at a distance is drawn with it; what makes it comes when asked for.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { exportAs, idle, showTab, status } from "./support/page.ts";
import { site } from "./support/site.ts";

/** Asks for a layer, and waits for what is said of it. */
async function layOut(page: Page, distance: string, says: RegExp, keeps?: string): Promise<void> {
  await showTab(page, "Check and make");
  const part = page.locator("details").filter({ hasText: "Second layer" });
  if ((await part.getAttribute("open")) === null) await part.locator("summary").click();
  await part.getByRole("spinbutton").fill(distance);
  const form = part.getByRole("combobox", { name: "Offset kind" });
  await form.selectOption(keeps ?? "What the design allows");
  await part.getByRole("button", { name: "Show" }).click();
  await expect.poll(() => part.locator("[aria-live]").innerText()).toMatch(says);
}

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
