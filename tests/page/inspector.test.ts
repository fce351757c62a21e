// SPDX-License-Identifier: MIT
// The inspector stays calm: three tabs, few controls at first sight, and what leads to a section opens its tab.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, movedCount, ruleChip, showTab, typeTarget } from "../browser/support/page.ts";
import { hintedPoint, press } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

const TABS = ["Edit", "Explore", "Check and make"] as const;

const tab = (page: Page, name: string) => page.getByRole("tab", { name, exact: true });

const button = (page: Page, name: string | RegExp) => page.getByRole("button", { name });

async function expectShown(page: Page, name: (typeof TABS)[number]): Promise<void> {
  await expect.poll(() => tab(page, name).getAttribute("aria-selected")).toBe("true");
  expect(await page.getByRole("tabpanel").count()).toBe(1);
  expect(await page.getByRole("tabpanel", { name, exact: true }).count()).toBe(1);
}

/** All that can be pressed, set or typed into, the "?" of help and what unfolds counted. */
const controls = (page: Page): Promise<number> =>
  page
    .locator("#inspector :is(button, input, select, textarea, summary)")
    .filter({ visible: true })
    .count();

/** By its letters, as a person finds it. */
async function command(page: Page, letters: string): Promise<void> {
  await page.keyboard.press("Control+k");
  await page.getByRole("combobox", { name: "Command" }).fill(letters);
  await page.keyboard.press("Enter");
  await idle(page);
}

/** How the long way up of a point ends: held back. */
async function dragFar(page: Page): Promise<void> {
  const at = await hintedPoint(page);
  await press(page, at, { x: at.x, y: at.y - 260 });
  await page.mouse.up();
  await idle(page);
}

it("has at most 25 controls at first sight, in any of its tabs", async () => {
  const page = await site.open();
  await button(page, "Group points").waitFor();
  expect(await controls(page)).toBeLessThanOrEqual(25);
  await showTab(page, "Explore");
  expect(await controls(page)).toBeLessThanOrEqual(25);
  await showTab(page, "Check and make");
  expect(await controls(page)).toBeLessThanOrEqual(30); // eight panels and seven columns of their table
  await page.context().close();
});

it("shows one tab, by click and by arrows, which go round", async () => {
  const page = await site.open();
  await expectShown(page, "Edit");
  await tab(page, "Explore").click();
  await expectShown(page, "Explore");
  for (const [key, name] of [
    ["ArrowRight", "Check and make"],
    ["ArrowRight", "Edit"],
    ["ArrowLeft", "Check and make"],
    ["Home", "Edit"],
    ["End", "Check and make"],
  ] as const) {
    await page.getByRole("tab", { selected: true }).press(key);
    await expectShown(page, name);
    expect(await page.evaluate(() => document.activeElement?.textContent)).toBe(name);
  }
  await page.context().close();
});

it("what leads to a section brings its tab into sight, a drag that stops too", async () => {
  const page = await site.open();
  await showTab(page, "Check and make");
  await dragFar(page);
  await expectShown(page, "Edit");
  await page.getByRole("region", { name: "Why the target is not reached" }).waitFor();
  await button(page, "Check its panels").click();
  await expectShown(page, "Check and make");
  for (const [letters, name] of [
    ["find variations", "Explore"],
    ["make exact", "Check and make"],
    ["go to edit", "Edit"],
    ["go to explore", "Explore"],
    ["rules: limits", "Edit"],
  ] as const) {
    await command(page, letters);
    await expectShown(page, name);
  }
  expect(await ruleChip(page, "Limits").getAttribute("aria-expanded")).toBe("true");
  await button(page, /panels to make again/).click();
  await expectShown(page, "Check and make");
  await command(page, "keep this view");
  await page.getByRole("textbox", { name: "Name of View 1" }).waitFor();
  await page.context().close();
});

it("three variants are compared in at most eight actions", async () => {
  const page = await site.open();
  await typeTarget(page, "+60cm");
  let actions = 0;
  const act = async (name: string | RegExp): Promise<void> => {
    await button(page, name).first().click();
    await idle(page);
    ++actions;
  };
  await act("Find variations");
  for (const number of [1, 2, 3]) await act(`Snapshot of design ${number}`);
  await act(/^Compare$/);
  const dialog = page.getByRole("dialog", { name: "Compare" });
  for (const number of [1, 2, 3])
    await dialog.getByText(`Snapshot ${number}`, { exact: true }).first().waitFor();
  expect(actions).toBeLessThanOrEqual(8);
  await page.context().close();
});

it("a snapshot is taken beside Undo and at every variation, which stays a variation", async () => {
  const page = await site.open();
  await typeTarget(page, "+60cm");
  await button(page, /^Snapshot$/).click();
  await page.getByText("Snapshot 1 is kept, under Explore.").waitFor();
  await button(page, "Find variations").click();
  await idle(page);
  const moved = await movedCount(page);
  const tiles = page.getByRole("list", { name: "Gallery of variations" });
  const adopts = await tiles.getByRole("button", { name: /^Adopt design/ }).count();
  const keeps = tiles.getByRole("button", { name: /^Snapshot of design/ });
  expect(await keeps.count()).toBe(adopts);
  await keeps.last().click();
  await idle(page);
  expect(await movedCount(page)).toBe(moved);
  expect(await keeps.last().isDisabled()).toBe(true);
  const named = page.getByRole("list", { name: "Snapshots" }).getByRole("listitem");
  expect(await named.count()).toBe(2);
  await button(page, "Adopt Snapshot 2").click();
  await idle(page);
  expect(await tiles.getByRole("button", { pressed: true }).count()).toBe(1);
  await page.context().close();
});

it("rules are chips that count them; one editor is open, none at first", async () => {
  const page = await site.open();
  const editors = ["Limits", "Supports", "Keep-outs", "Symmetry"];
  const open = async (): Promise<string[]> => {
    const shown = editors.map((name) =>
      page.getByRole("region", { name, exact: true }).filter({ visible: true }).count(),
    );
    const counts = await Promise.all(shown);
    return editors.filter((_, k) => counts[k] === 1);
  };
  await page.getByRole("heading", { name: "Rules", exact: true }).waitFor();
  expect(await open()).toEqual([]);
  for (const name of editors) {
    await ruleChip(page, name).click();
    expect(await open()).toEqual([name]);
  }
  await button(page, "All that it has").click();
  await page.getByRole("heading", { name: "Rules (1)" }).waitFor();
  await ruleChip(page, "Limits").click();
  await page.getByRole("checkbox", { name: "Folds up to" }).check();
  await page.getByRole("heading", { name: "Rules (2)" }).waitFor();
  expect(await ruleChip(page, "Limits").innerText()).toBe("Limits 1");
  await ruleChip(page, "Limits").click();
  expect(await open()).toEqual([]);
  await page.context().close();
});
