// SPDX-License-Identifier: MIT
// What an expert looks for: health of panels, sorting, how the solve went, settings behind a fold.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, pickFile, typeTarget } from "../browser/support/page.ts";
import { site } from "./support/site.ts";

/** The cells of one column of the table Panels. */
async function column(page: Page, place: number): Promise<string[]> {
  const rows = page.getByRole("table", { name: "Panels" }).getByRole("row");
  const texts = await rows.evaluateAll(
    (all, k) => all.slice(1).map((row) => row.children[k]?.textContent ?? ""),
    place,
  );
  return texts;
}

it("says why a target is refused: how far short, which panels hold it; each can be seen", async () => {
  const page = await site.openVault({ viewport: { width: 1280, height: 900 } });
  await typeTarget(page, "+10cm");
  // Everything around the point is held: nothing can follow it.
  const why = page.getByRole("region", { name: "Why the target is not reached" });
  await idle(page);
  expect(await why.count()).toBe(0);
  await page.getByLabel("3D view").focus();
  for (const way of ["ArrowRight", "ArrowUp", "ArrowLeft", "ArrowLeft", "ArrowDown", "ArrowDown"])
    await page.keyboard.press(`Control+${way}`);
  for (const way of ["ArrowRight", "ArrowRight"]) await page.keyboard.press(`Control+${way}`);
  await page.getByRole("table", { name: "Handles" }).getByRole("rowheader").first().waitFor();
  await page.getByRole("button", { name: "Pin selected points" }).click();
  await idle(page);
  const first = page.getByRole("checkbox", { name: "Pinned" }).first();
  if (await first.isChecked()) await first.uncheck();
  await idle(page);
  await expect.poll(() => why.textContent()).toMatch(/^Panels allow (< )?[\d.]+ of \d+ mm here/);
  await page.getByText("Advanced", { exact: true }).click();
  await page.getByRole("checkbox", { name: "Meet the targets exactly" }).check();
  await idle(page);
  await expect.poll(() => why.textContent()).toMatch(/some would not stay flat and sound/);
  const shows = why.getByRole("button", { name: /^Show panel \d+$/ });
  await expect.poll(() => shows.count()).toBeGreaterThan(0);
  const panel = await shows.first().textContent();
  await shows.first().click();
  expect(await page.getByText(/ corners, /).textContent()).toContain(`Panel ${panel}`);
  await page.context().close();
});

it("marks panels that cross themselves, in words too", async () => {
  const page = await site.openVault({ viewport: { width: 1280, height: 900 } });
  const bowTie = "v 0 0 0\nv 2 1 0\nv 2 0 0\nv 0 1 0\nv 3 0 0\nv 3 1 0\nf 1 2 3 4\nf 3 5 6 2\n";
  await pickFile(page, "bow.obj", bowTie);
  await page.getByRole("button", { name: /Start editing|Leave as it is/ }).click();
  await expect.poll(() => page.getByText(/1 self-crossing/).count()).toBe(1);
  expect((await column(page, 5))[0]).toBe("crosses itself");
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Panel health");
  await expect.poll(() => page.getByText("crosses itself (bow-tie)").count()).toBe(1);
  await page.context().close();
});
