// SPDX-License-Identifier: MIT
// Which of the controls are in sight: one tab of the inspector, one rule's editor, the options of the view.
import { effect, signal } from "@preact/signals";
import { kept, type Page } from "./page.ts";

export const TABS = ["edit", "explore", "check"] as const;

export type Tab = (typeof TABS)[number];

/** What an edit has to keep to, beside flat panels, in the order in which it is shown. */
export const RULES = {
  limits: "Limits",
  supports: "Supports",
  keepOuts: "Keep-outs",
  symmetry: "Symmetry",
} as const;

export type Rule = keyof typeof RULES;

export const rulesInOrder = Object.keys(RULES) as readonly Rule[];

export const shownTab = kept(() => signal<Tab>("edit"));

/** null: the editors of all rules are closed. */
export const shownRule = kept(() => signal<Rule | null>(null));

/** Whether what changes the view alone is in sight, beside its buttons. */
export const viewOptionsShown = kept(() => signal(false));

/** Whether what asks for a second layer is unfolded. */
export const layerAsked = kept(() => signal(false));

/** How often a command asked for it: each time it is brought into sight. */
export const layerCalls = kept(() => signal(0));

/** Shows a tab, for whatever leads to a section of it. */
export function goToTab(page: Page, tab: Tab): void {
  shownTab(page).value = tab;
  page.sheetFolded.value = false;
}

export function goToRule(page: Page, rule: Rule): void {
  goToTab(page, "edit");
  shownRule(page).value = rule;
}

const KEY = "planish-tab";

/** A reload comes back to the tab that was in sight. Where the browser keeps nothing it begins anew. */
export function keepTab(page: Page): void {
  try {
    const before = TABS.find((tab) => tab === sessionStorage.getItem(KEY));
    if (before) shownTab(page).value = before;
    effect(() => sessionStorage.setItem(KEY, shownTab(page).value));
  } catch {
    // No storage in this frame.
  }
}
