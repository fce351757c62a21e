// SPDX-License-Identifier: MIT
import { signal } from "@preact/signals";
import { kept, type Page } from "../../state/page.ts";
import type { Command } from "../../ui/commands/command.ts";

/** Whether panels and points have their numbers on them in the view. */
export const numbered = kept(() => signal({ panels: false, points: false }));

export function toggleNumbers(page: Page, of: "panels" | "points"): void {
  const shown = numbered(page);
  shown.value = { ...shown.value, [of]: !shown.value[of] };
}

export const NUMBERS = [
  ["panels", "Number the panels"],
  ["points", "Number the points"],
] as const;

export const NUMBER_COMMANDS: readonly Command[] = NUMBERS.map(([of, label]) => ({
  label,
  run: (page) => toggleNumbers(page, of),
}));
