// SPDX-License-Identifier: MIT
// How many panels the shop makes again after a finished edit.

import { counted } from "../quantity/counted.ts";
import { healthShown } from "./damage.ts";
import type { Page } from "./page.ts";
import { countHealth } from "./panel-rows.ts";

/** 0 while that is not measured. */
export function panelsToRemake(page: Page): number {
  const health = healthShown(page).value;
  return health ? countHealth(health).changed : 0;
}

/** "244 panels to make again"; "" for none. */
export function remakeWords(page: Page): string {
  const changed = panelsToRemake(page);
  return changed === 0 ? "" : `${counted(changed, "panel")} to make again`;
}
