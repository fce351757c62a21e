// SPDX-License-Identifier: MIT
// How many panels the shop makes again after a finished edit.

import { counted } from "../quantity/counted.ts";
import { healthShown } from "./damage.ts";
import type { Page } from "./page.ts";
import { countHealth } from "./panel-rows.ts";

/** "244 panels to make again"; "" while that is not measured, and for none. */
export function remakeWords(page: Page): string {
  const health = healthShown(page).value;
  const { changed } = health ? countHealth(health) : { changed: 0 };
  return changed === 0 ? "" : `${counted(changed, "panel")} to make again`;
}
