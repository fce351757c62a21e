// SPDX-License-Identifier: MIT
// Needs: layout.
// The "?" beside controls: each opens a sentence with a moving picture, inside the window, and closes again.
import type { Locator, Page } from "playwright-core";
import { expect, it } from "vitest";
import { expectClean } from "./support/axe.ts";
import { idle, openRule, openViewOptions, showTab } from "./support/page.ts";
import { site } from "./support/site.ts";

/** Those that can be pressed now: what is folded away has its own inside. */
const asks = (page: Page): Locator => page.getByRole("button", { name: /^What is this\?/ });

/** Everything in the tab that is in sight. */
async function unfold(page: Page): Promise<void> {
  const summaries = page.locator("#inspector summary").filter({ visible: true });
  for (const summary of await summaries.all()) await summary.click();
}

/** By what it says: a note on several things has a button for each. */
async function read(page: Page, seen: (note: Locator) => Promise<void>): Promise<void> {
  const note = page.getByRole("note");
  await seen(note);
  for (const subject of await note.getByRole("button").all()) {
    await subject.click();
    await seen(note);
  }
}

async function lookAtAll(page: Page, seen: (note: Locator) => Promise<void>): Promise<string[]> {
  const names: string[] = [];
  // Sections come with the first look at their tab.
  await idle(page);
  await asks(page).nth(2).waitFor({ state: "attached" });
  for (const ask of await asks(page).all()) {
    if (!(await ask.isVisible())) continue;
    await ask.click();
    const note = page.getByRole("note");
    await read(page, seen);
    const box = await note.boundingBox();
    const { width, height } = page.viewportSize() ?? { width: 0, height: 0 };
    expect(box && box.x >= 0 && box.y >= 0).toBe(true);
    expect(box && box.x + box.width <= width && box.y + box.height <= height).toBe(true);
    await page.keyboard.press("Escape");
    await note.waitFor({ state: "detached" });
    names.push((await ask.getAttribute("aria-label")) ?? "");
  }
  return names;
}

it("every section has one that moves, by mouse and keys", async () => {
  const page = await site.openVault({ reducedMotion: "no-preference" });
  const told = new Set<string>();
  const look = async (): Promise<void> => {
    const names = await lookAtAll(page, async (note) => {
      const words = (await note.locator("p").textContent()) ?? "";
      expect(words.length).toBeGreaterThan(30);
      expect(await note.locator("animate").count()).toBeGreaterThan(0);
      told.add(words);
    });
    expect(new Set(names).size).toBe(names.length);
  };
  // Two points are chosen, which have sections of their own; Escape that comes late lets go of them.
  const chosen = page.locator(".marker:not([hidden])");
  const chooseTwo = async (): Promise<void> => {
    await idle(page);
    if ((await chosen.count()) >= 2) return;
    await page.getByLabel("3D view").focus();
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("Control+ArrowRight");
    await chosen.nth(1).waitFor();
  };
  const lookEverywhere = async (): Promise<void> => {
    await chooseTwo();
    await showTab(page, "Edit");
    await look();
    for (const name of ["Limits", "Supports", "Keep-outs", "Symmetry"]) {
      await openRule(page, name);
      await look();
    }
    await openViewOptions(page);
    for (const name of ["Explore", "Check and make"] as const) {
      await showTab(page, name);
      await look();
    }
  };
  await chooseTwo();
  await unfold(page);
  await lookEverywhere();
  // What is measured first, or fetched with its rule, may have come after it was left.
  for (let again = 0; again < 3 && told.size < 21; ++again) await lookEverywhere();
  expect(told.size, [...told].map((words) => words.slice(0, 12)).join("|")).toBeGreaterThanOrEqual(
    21,
  );
  await asks(page).first().focus();
  await page.keyboard.press("Enter");
  await page.getByRole("note").waitFor();
  await expectClean(page, "a note is open");
  await page.context().close();
});

it("stands still where motion is not wanted, and fits a phone", async () => {
  const page = await site.open({ viewport: { width: 320, height: 568 }, reducedMotion: "reduce" });
  const names = await lookAtAll(page, async (note) => {
    expect(await note.locator("animate").count()).toBe(0);
    expect(await note.locator("polyline").count()).toBeGreaterThan(0);
  });
  expect(names.length).toBeGreaterThanOrEqual(3);
  await page.context().close();
});
