// SPDX-License-Identifier: MIT
// The regions of the page, in the order of F6: bar, view, inspector; with Shift the other way.

/** What takes the keyboard in each of them. */
const REGIONS = [".top-bar :is(button, select)", "canvas", ".inspector :is(button, input, select)"];

const canTakeIt = (element: HTMLElement): boolean =>
  element.checkVisibility() && !(element as HTMLButtonElement).disabled;

/** Where the keyboard is: an index of REGIONS, or −1. */
const here = (): number =>
  REGIONS.findIndex((region) => {
    const around = document.querySelector(region.split(" ")[0] ?? region);
    return around?.contains(document.activeElement);
  });

/** Focuses the first that can take it in the next region, or with −1 in the one before. */
export function goToRegion(step: 1 | -1): void {
  const count = REGIONS.length;
  const start = here();
  const next = start < 0 ? (step > 0 ? 0 : count - 1) : (start + step + count) % count;
  const candidates = document.querySelectorAll<HTMLElement>(REGIONS[next] ?? "canvas");
  [...candidates].find(canTakeIt)?.focus();
}
