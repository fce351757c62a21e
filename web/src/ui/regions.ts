// SPDX-License-Identifier: MIT
// The regions of the page, in the order of F6: bar, view, inspector; with Shift the other way.

/** What takes the keyboard in each of them. */
const REGIONS = {
  bar: ".top-bar :is(button, select)",
  view: "canvas",
  inspector: ".sheet-fold, .inspector :is(button, input, select):not([tabindex='-1'])",
} as const;

const AROUND = {
  bar: ".top-bar",
  view: "canvas",
  inspector: ".sheet-fold, .inspector",
} as const;

export type Region = keyof typeof REGIONS;

const NAMES = Object.keys(REGIONS) as Region[];

const canTakeIt = (element: HTMLElement): boolean =>
  element.checkVisibility() && !(element as HTMLButtonElement).disabled;

/** Where the keyboard is: an index of NAMES, or −1. */
const here = (): number => NAMES.findIndex((name) => document.activeElement?.closest(AROUND[name]));

/** Focuses the first that can take it in a region. */
export function enterRegion(region: Region): void {
  const candidates = document.querySelectorAll<HTMLElement>(REGIONS[region]);
  [...candidates].find(canTakeIt)?.focus();
}

/** Focuses the next region, or with −1 the one before. */
export function goToRegion(step: 1 | -1): void {
  const count = NAMES.length;
  const start = here();
  const next = start < 0 ? (step > 0 ? 0 : count - 1) : (start + step + count) % count;
  enterRegion(NAMES[next] ?? "view");
}
