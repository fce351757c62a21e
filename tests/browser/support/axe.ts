// SPDX-License-Identifier: MIT
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { expect } from "vitest";

/** A page of either engine. */
interface Page {
  evaluate(script: string): Promise<unknown>;
}

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
/** Off by default: targets of at least 24 pixels, which WCAG 2.2 AA asks for. */
const RULES = `{ rules: { "target-size": { enabled: true } } }`;

/** What depends on the colours alone. */
const COLOUR_RULES = `{ runOnly: ["color-contrast", "link-in-text-block"] }`;

interface Violation {
  readonly id: string;
  readonly nodes: readonly { readonly html: string; readonly failureSummary?: string }[];
}

async function look(page: Page, state: string, within: string, rules: string): Promise<void> {
  if (await page.evaluate(`!("axe" in window)`)) await page.evaluate(AXE);
  const violations = (await page.evaluate(
    `axe.run(${JSON.stringify(within)}, ${rules}).then((result) => result.violations)`,
  )) as Violation[];
  const told = violations.map(
    ({ id, nodes }) => `${state}: ${id}\n${nodes[0]?.failureSummary}\n${nodes[0]?.html}`,
  );
  expect(told).toEqual([]);
}

/**
 * Fails with what axe finds in the page as it is now.
 * @param within a selector of the part that is looked at: the whole page takes a second
 */
export const expectClean = (page: Page, state: string, within = "html"): Promise<void> =>
  look(page, state, within, RULES);

/** The same for what depends on the colours alone. */
export const expectReadable = (page: Page, state: string, within = "html"): Promise<void> =>
  look(page, state, within, COLOUR_RULES);
