// SPDX-License-Identifier: MIT
// The panels one by one: a table that fits and goes on, a scale that says what it is, a legend that
// leads to its panels; and words that need no paper to be read.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, openFile, pickFile, typeTarget } from "../browser/support/page.ts";
import { site } from "./support/site.ts";

const BOW_TIE = "v 0 0 0\nv 2 1 0\nv 2 0 0\nv 0 1 0\nv 3 0 0\nv 3 1 0\nf 1 2 3 4\nf 3 5 6 2\n";

const table = (page: Page) => page.getByRole("table", { name: "Panels" });

const shows = (page: Page) => table(page).getByRole("button", { name: /^Show panel \d+$/ });

it("goes on by keyboard, and lists those alone that must be made again", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await typeTarget(page, "+40cm");
  await expect.poll(() => shows(page).count()).toBe(8);
  await page.getByRole("button", { name: "Show 50 more" }).focus();
  await page.keyboard.press("Enter");
  expect(await shows(page).count()).toBe(58);
  await page.keyboard.press("Enter");
  expect(await shows(page).count()).toBe(108);
  const summary = await page.getByText(/panels must be made again after this edit/).textContent();
  const changed = Number.parseInt(summary ?? "", 10);
  expect(changed).toBeGreaterThan(0);
  const nodes = /only, and (\d+) nodes, (\d+) of them with new angles only; /.exec(summary ?? "");
  expect(Number(nodes?.[2])).toBeGreaterThan(0);
  expect(Number(nodes?.[1])).toBeGreaterThan(Number(nodes?.[2]));
  await page.getByRole("checkbox", { name: "Only panels that must be made again" }).check();
  expect(await shows(page).count()).toBe(Math.min(108, changed));
  expect(await page.getByText(new RegExp(`of ${changed} panels`)).count()).toBe(1);
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  await expect.poll(() => shows(page).count()).toBe(0);
  await page.context().close();
});

it("goes to the next panel of a class of the legend", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await pickFile(page, "bow.obj", BOW_TIE);
  await page.getByRole("button", { name: "Start editing" }).click();
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Panel health");
  await page.getByRole("button", { name: /^crosses itself \(bow-tie\)\s*1$/ }).press("Enter");
  await expect.poll(() => page.getByText(/^Panel 0 4 corners.*crosses itself/).count()).toBe(1);
  await page.getByRole("button", { name: /^convex\s*1$/ }).click();
  await expect.poll(() => page.getByText(/^Panel 1 4 corners.*convex/).count()).toBe(1);
  expect(await page.getByRole("button", { name: /^concave/ }).isDisabled()).toBe(true);
  // A file that has such panels is not all well only because they are flat.
  expect(await page.getByText("But 1 panel crosses itself, as in the file.").count()).toBe(1);
  await page.context().close();
});

it("speaks of millimetres, and of flat panels only where they are flat", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await typeTarget(page, "+40cm");
  await page.getByText("Last solve", { exact: true }).click();
  const curve = page.getByRole("img", { name: /^Residual of \d+ steps/ });
  expect(await curve.getAttribute("aria-label")).toMatch(
    /from [\d.]+ mm to (less than )?[\d.]+ mm/,
  );
  expect(await page.getByText(/mean edge/).count()).toBe(0);
  const view = page.getByRole("application", { name: "3D view" });
  const summary = async (): Promise<string> => {
    const id = await view.getAttribute("aria-describedby");
    return (await page.locator(`#${id}`).textContent()) ?? "";
  };
  expect(await summary()).toContain("400 flat panels");
  await openFile(page, "bent.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nf 1 2 3 4\n");
  // The door shows what planarising would make of it, and the file is still as it was.
  await expect
    .poll(summary)
    .toMatch(/^A preview of planarising: 1 panels would all be flat, with .* is not flat\./);
  expect(await summary()).not.toContain("flat panels");
  await page.context().close();
});
