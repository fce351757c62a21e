// SPDX-License-Identifier: MIT
// The panels one by one: a table that fits and goes on, a scale that says what it is, a legend that
// leads to its panels; and words that need no paper to be read.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import {
  idle,
  openFile,
  openLastSolve,
  pickFile,
  showTab,
  typeTarget,
} from "../browser/support/page.ts";
import { site } from "./support/site.ts";

const BOW_TIE = "v 0 0 0\nv 2 1 0\nv 2 0 0\nv 0 1 0\nv 3 0 0\nv 3 1 0\nf 1 2 3 4\nf 3 5 6 2\n";

const table = (page: Page) => page.getByRole("table", { name: "Panels" });

const shows = (page: Page) => table(page).getByRole("button", { name: /^Show panel \d+$/ });

it("goes on by keyboard, and lists those alone that must be made again", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await typeTarget(page, "+40cm");
  await showTab(page, "Check and make");
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
  await openLastSolve(page);
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
  expect(await summary()).toContain("196 flat panels");
  await openFile(page, "bent.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nf 1 2 3 4\n");
  // The door shows what planarising would make of it, and the file is still as it was.
  await expect
    .poll(summary)
    .toMatch(/^A preview of planarising: 1 panels would all be flat, with .* is not flat\./);
  expect(await summary()).not.toContain("flat panels");
  await page.context().close();
});

it("says how many panels must be made again after the edit", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  const note = page.getByRole("button", { name: /^\d+ panels to make again$/ });
  await typeTarget(page, "+40cm");
  await expect.poll(() => note.count()).toBe(1);
  const total = Number.parseInt((await note.textContent()) ?? "", 10);
  await note.press("Enter");
  expect(await page.getByRole("combobox", { name: "Colour by" }).inputValue()).toBe("remake");
  const legend = page.getByRole("group", { name: "Legend", exact: true });
  const countOf = async (word: string): Promise<number> => {
    const text = await legend.getByRole("button", { name: new RegExp(`^${word}`) }).textContent();
    return Number(/\d+$/.exec(text ?? "")?.[0]);
  };
  await expect.poll(() => countOf("cut again")).toBeGreaterThan(0);
  const [cut, bevel] = [await countOf("cut again"), await countOf("new bevel only")];
  expect(bevel).toBeGreaterThan(0);
  expect(cut + bevel).toBe(total);
  expect(await countOf("unchanged")).toBe(196 - total);
  await legend.getByRole("button", { name: /^new bevel only/ }).click();
  await page.getByText(/^Panel \d+ 4 corners/).waitFor();
  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => note.count()).toBe(0);
  await expect.poll(() => countOf("unchanged")).toBe(196);
  await page.context().close();
});

it("shows those panels first that fold most", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await typeTarget(page, "+40cm");
  await showTab(page, "Check and make");
  await expect.poll(() => shows(page).count()).toBe(8);
  const folds = await table(page)
    .getByRole("row")
    .evaluateAll((rows) => rows.slice(1).map((row) => Number(row.lastElementChild?.textContent)));
  expect(folds.length).toBeGreaterThan(4);
  expect(folds[0]).toBeGreaterThan(5);
  expect([...folds].sort((a, b) => b - a)).toEqual(folds);
  await page.context().close();
});

/** A tilted plane of quads of nearly 1 m, so far from the origin that its coordinates are coarse. */
function farPlane(offset: number): string {
  const lines: string[] = [];
  for (let j = 0; j < 4; ++j)
    for (let i = 0; i < 4; ++i) {
      const [x, y] = [0.9 * i + 0.13 * j, 0.7 * j - 0.11 * i];
      lines.push(`v ${offset + x} ${offset + y} ${0.9 * x + 0.8 * y}`);
    }
  for (let j = 0; j < 3; ++j)
    for (let i = 0; i < 3; ++i) {
      const a = 4 * j + i + 1;
      lines.push(`f ${a} ${a + 1} ${a + 5} ${a + 4}`);
    }
  return lines.join("\n");
}

it("calls flat what the coordinates cannot hold flatter, and says so", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  const verdict = page.getByText(/^(Every|Worst) panel/).last();
  const kind = (): Promise<string> => verdict.evaluate((at) => at.className);
  await expect.poll(() => verdict.textContent()).toBe("Every panel is flat (< 0.000001 mm/m).");
  const good = await kind();
  await openFile(page, "far.obj", farPlane(1e8 + 0.1));
  const held = /as flat as its coordinates can hold \(0\.0000\d+ mm\/m\)/;
  await page.getByRole("definition").filter({ hasText: held }).waitFor();
  expect(await page.getByRole("button", { name: "Planarise" }).count()).toBe(0);
  await page.getByRole("button", { name: "Start editing" }).click();
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Planarity");
  await expect.poll(() => verdict.textContent()).toMatch(/^Every panel is as flat as/);
  expect(await kind()).toBe(good);
  await page.getByText("0 panels out of flat, 9 flat").waitFor();
  expect(await page.getByRole("status").textContent()).toContain("flat but for rounding");
  await page.context().close();
});
