// SPDX-License-Identifier: MIT
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { Page } from "playwright-core";
import { expect } from "vitest";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
/** Off by default: targets of at least 24 pixels, which WCAG 2.2 AA asks for. */
const RULES = `{ rules: { "target-size": { enabled: true } } }`;

interface Violation {
  readonly id: string;
  readonly nodes: readonly { readonly html: string; readonly failureSummary?: string }[];
}

/**
 * Fails with what axe finds in the page as it is now.
 * @param within a selector of the part that is looked at: the whole page takes a second
 */
export async function expectClean(page: Page, state: string, within = "html"): Promise<void> {
  if (await page.evaluate(`!("axe" in window)`)) await page.evaluate(AXE);
  const violations = (await page.evaluate(
    `axe.run(${JSON.stringify(within)}, ${RULES}).then((result) => result.violations)`,
  )) as Violation[];
  const told = violations.map(
    ({ id, nodes }) => `${state}: ${id}\n${nodes[0]?.failureSummary}\n${nodes[0]?.html}`,
  );
  expect(told).toEqual([]);
}
