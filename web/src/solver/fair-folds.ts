// SPDX-License-Identifier: MIT
// Where an edit folds panels sharply though it need not: the same edit with a limit on its folds.
import type { ShapeReport } from "./protocol.ts";

/** Degrees by which folds may sharpen: a limit is tried at each, the first that takes nothing stands. */
export const FAIR_STEPS: readonly number[] = [10, 20];
/** The limits that are tried. */
export const FAIR_LIMITS: readonly string[] = FAIR_STEPS.map((degrees) => `fold=+${degrees}`);
/** Share of the way to the targets that handles may lose by it. */
const LOSS = 0.05;

/** By how much the fold that sharpened most did, degrees. */
export const foldGrowth = ({ sharpestFold: fold }: ShapeReport): number =>
  fold ? (fold.growth ?? fold.after - fold.before) : 0;

/** Makes the edit with one more limit. */
export type LimitedEdit = (limit: string) => ShapeReport;

/**
 * The limit with which the handles get as far as in `free`, the edit without one; null where none is
 * needed, or none of those tried lets them. The last edit that was made is the one that stands, unless
 * the result is null and edits were made.
 * @param way of the handle that goes furthest, from the base to its target; model units
 */
export function fairLimit(free: ShapeReport, way: number, edit: LimitedEdit): string | null {
  const growth = foldGrowth(free);
  for (const degrees of FAIR_STEPS.filter((step) => step < growth)) {
    const limit = `fold=+${degrees}`;
    const report = edit(limit);
    if (report.movedVertices === 0 || report.status === "infeasible_handles") continue;
    if (report.handleError <= free.handleError + LOSS * way) return limit;
  }
  return null;
}
