// SPDX-License-Identifier: MIT
// Needs: pixels, network.
// Export → Second layer…: the design at a distance is drawn with it; what makes it comes when asked for.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { exportAs, idle, status } from "./support/page.ts";
import { site } from "./support/site.ts";

async function layOut(page: Page, distance: string, keeps?: string): Promise<string> {
  await page.getByRole("button", { name: "Export" }).click();
  await page.getByRole("button", { name: "Second layer…" }).click();
  const dialog = page.getByRole("dialog", { name: "Second layer" });
  await dialog.getByRole("spinbutton").fill(distance);
  if (keeps) await dialog.getByRole("combobox", { name: "Offset kind" }).selectOption(keeps);
  await dialog.getByRole("button", { name: "Show" }).click();
  const said = dialog.locator("[aria-live]");
  await expect.poll(() => said.innerText()).not.toBe("");
  const words = await said.innerText();
  await page.keyboard.press("Escape");
  return words;
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
  expect(await layOut(page, "0.25")).toBe("Panels lie at 250 mm everywhere.");
  expect(requests.join()).toContain("planish_documents");
  await expect.poll(async () => (await picture()) !== before).toBe(true);
  await page.context().close();
});

it("of a design without the offset that is asked for the dialog says what it misses", async () => {
  const page = await site.open();
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Vault");
  await idle(page);
  expect(await layOut(page, "0.2", "Points at the distance")).toMatch(
    /^No second layer: points at one distance have no parallel edges: panel \d+ misses a circle by [\d.]+ deg\. Make panels circular \(Advanced\) makes it so\.$/,
  );
  expect(await page.getByRole("region", { name: "Second layer" }).count()).toBe(0);
  expect(await layOut(page, "-0.2")).toMatch(
    /^Edges are parallel; points lie at -\d+ mm to -\d+ mm\./,
  );
  await page.getByRole("region", { name: "Second layer" }).waitFor();
  // It goes with its mesh.
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Dome");
  await expect.poll(() => page.getByRole("region", { name: "Second layer" }).count()).toBe(0);
  expect(await status(page)).not.toContain("offset");
  await page.context().close();
});
