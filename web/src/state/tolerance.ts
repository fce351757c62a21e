// SPDX-License-Identifier: MIT
// Up to how much out of flat a panel counts as flat.
import { commitSettings } from "./editing.ts";
import { FLAT_TEXT } from "./flatness.ts";
import { baseFlat, importReport, mesh } from "./store.ts";

/** mm/m, the tightest first. Edits of meshes bent more than the last find no way from where they are:
 * docs/decisions/0028-planarising-is-tried-out.md. */
export const TOLERANCES = [FLAT_TEXT, "0.001", "1", "20"] as const;

/** The tightest that is offered and that the opened mesh meets; null if none, or if it is flat as it is. */
export function meetableTolerance(): string | null {
  const worst = mesh.value?.report.worstExcess;
  if (worst === undefined || baseFlat.value) return null;
  return TOLERANCES.find((tolerance) => worst <= Number(tolerance)) ?? null;
}

/** Takes the opened mesh as flat enough: its points stay as they are. */
export function acceptTolerance(tolerance: string): Promise<void> {
  importReport.value = false;
  return commitSettings({ tolerance: Number(tolerance) });
}
