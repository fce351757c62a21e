// SPDX-License-Identifier: MIT
// axe finds nothing in any state of the page, light and dark.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { idle, movedCount, openSite, type Site } from "./support/page.ts";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

let site: Site;
beforeAll(async () => {
  site = await openSite();
});
afterAll(() => site.close());

interface Violation {
  readonly id: string;
  readonly nodes: readonly { readonly html: string; readonly failureSummary?: string }[];
}

async function expectClean(page: Page, state: string): Promise<void> {
  const violations = (await page.evaluate(
    `${AXE}; axe.run(document).then((result) => result.violations)`,
  )) as Violation[];
  const told = violations.map(
    ({ id, nodes }) => `${state}: ${id}\n${nodes[0]?.failureSummary}\n${nodes[0]?.html}`,
  );
  expect(told).toEqual([]);
}

async function edit(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Add handle" }).click();
  const z = page.getByRole("spinbutton", { name: "Z" });
  await z.fill("+0.4");
  await z.press("Enter");
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
}

describe.each(["light", "dark"] as const)("in %s", (colorScheme) => {
  it("nothing is wrong in any state", async () => {
    const page = await site.open({ colorScheme, reducedMotion: "reduce" });
    await expectClean(page, "first visit");
    await edit(page);
    await expectClean(page, "edited");
    await page.getByRole("button", { name: "Export" }).click();
    await expectClean(page, "export menu");
    await page.keyboard.press("Escape");
    await page.getByRole("button", { name: "Help" }).click();
    await expectClean(page, "help");
    await page.keyboard.press("Escape");
    await page.getByRole("button", { name: "Share" }).click();
    await expectClean(page, "share");
    await page.keyboard.press("Escape");
    await page.getByRole("button", { name: "Find variations" }).click();
    await expect.poll(() => page.getByRole("slider", { name: "Variation 1" }).count()).toBe(1);
    await expectClean(page, "variations");
    const gallery = page.getByRole("list", { name: "Gallery of variations" });
    await expect.poll(() => gallery.getAttribute("aria-busy"), { timeout: 20_000 }).toBe("false");
    await page.getByRole("button", { name: "Take snapshot" }).click();
    await expectClean(page, "gallery and snapshots");
    await page.context().close();
  });
});

it("nothing is wrong on a small screen", async () => {
  const page = await site.open({ viewport: { width: 360, height: 740 }, reducedMotion: "reduce" });
  await edit(page);
  await expectClean(page, "small");
  expect(await page.evaluate("document.documentElement.scrollWidth")).toBeLessThanOrEqual(360);
  await page.context().close();
});
