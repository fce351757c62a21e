// SPDX-License-Identifier: MIT
// Up to how much out of flat a panel counts as flat.

import { FLAT_TEXT } from "../design/flatness.ts";
import { commitSettings } from "./editing.ts";
import type { Page } from "./page.ts";
import type { Outcome } from "./turns.ts";

/** mm/m, the tightest first. Edits of meshes bent more than the last find no way from where they are:
 * docs/decisions/0028-planarising-is-tried-out.md. */
export const TOLERANCES = [FLAT_TEXT, "0.001", "1", "20"] as const;

/** The tightest that is offered and that the opened mesh meets; null if none, or if it is flat as it is. */
export function meetableTolerance(page: Page): string | null {
  const worst = page.mesh.value?.report.worstExcess;
  if (worst === undefined || page.baseFlat.value) return null;
  return TOLERANCES.find((tolerance) => worst <= Number(tolerance)) ?? null;
}

/** Takes the opened mesh as flat enough: its points stay as they are. */
export function acceptTolerance(page: Page, tolerance: string): Outcome {
  page.importReport.value = false;
  return commitSettings(page, { tolerance: Number(tolerance) });
}
