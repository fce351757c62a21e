// SPDX-License-Identifier: MIT
import { signal } from "@preact/signals";
import { kept, type Page } from "../../state/page.ts";

/** Whether panels and points have their numbers on them in the view. */
export const numbered = kept(() => signal({ panels: false, points: false }));

export function toggleNumbers(page: Page, of: "panels" | "points"): void {
  const shown = numbered(page);
  shown.value = { ...shown.value, [of]: !shown.value[of] };
}
