// SPDX-License-Identifier: MIT
// How much out of flat a panel may be that counts as flat.

import { FLAT_TEXT } from "../design/flatness.ts";
import type { EditSettings } from "../solver/protocol.ts";
import type { Outcome } from "./action-queue.ts";
import { commitSettings } from "./editing.ts";
import type { Page } from "./page.ts";

/** mm/m, the tightest first. What edits touch of a mesh within one of them becomes flat; of one that is bent more it
 * stays as bent as it is: docs/decisions/0028-planarising-is-tried-out.md. */
export const TOLERANCES = [FLAT_TEXT, "0.001", "1", "20"] as const;

/** With what the opened mesh can be edited as it is; null if it is flat. */
export function settingsAsItIs(page: Page): Pick<EditSettings, "tolerance" | "keepBends"> | null {
  const worst = page.mesh.value?.report.worstExcess;
  if (worst === undefined || page.baseFlat.value) return null;
  const met = TOLERANCES.find((tolerance) => worst <= Number(tolerance));
  return met
    ? { tolerance: Number(met), keepBends: false }
    : { tolerance: Math.ceil(worst), keepBends: true };
}

/** Takes the opened mesh as flat enough: its points stay as they are. */
export function editAsItIs(page: Page, settings: Partial<EditSettings>): Outcome {
  page.importReport.value = false;
  page.toleranceTaken.value = true;
  return commitSettings(page, settings);
}
