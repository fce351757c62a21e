// SPDX-License-Identifier: MIT
// How many panels the shop makes again after a finished edit.

import { damage } from "./damage.ts";
import type { Page } from "./page.ts";
import { countHealth } from "./panel-rows.ts";

/** "244 panels to make again"; "" while that is not measured, and for none. */
export function remakeWords(page: Page): string {
  // Measured together: while there is no word on the damage, health is that of an earlier design.
  const health = damage(page).value && page.panelHealth.value;
  const { changed } = health ? countHealth(health) : { changed: 0 };
  return changed === 0 ? "" : `${changed} ${changed === 1 ? "panel" : "panels"} to make again`;
}
