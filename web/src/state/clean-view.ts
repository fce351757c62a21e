// SPDX-License-Identifier: MIT
// Whether the view shows the design alone, as for a picture or a meeting: without what is there for the hand.
import { signal } from "@preact/signals";
import { kept, type Page } from "./page.ts";

export const cleanView = kept(() => signal(false));

export function toggleCleanView(page: Page): void {
  cleanView(page).value = !cleanView(page).value;
}
