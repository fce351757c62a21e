// SPDX-License-Identifier: MIT
// Where an edit folds panels sharply though it need not: the same edit with a limit on its folds.
import type { ShapeReport } from "./protocol.ts";

/** Degrees by which folds may sharpen: a limit is tried at each, the first that takes nothing stands. */
export const FAIR_STEPS: readonly number[] = [10, 20];
/** Of the limits that the page finds itself, all are multiples of it. */
const STEP = 10;
/** Share of the way to the targets that handles may lose by it. */
const LOSS = 0.05;

/** By how much the fold that sharpened most did, degrees. */
export const foldGrowth = ({ sharpestFold: fold }: ShapeReport): number =>
  fold ? (fold.growth ?? fold.after - fold.before) : 0;

/** Degrees: of the limits that the page finds the first that folds grown by as much keep. */
export const stepOf = (growth: number): number => {
  const ROUNDING = 0.01;
  return STEP * Math.max(1, Math.ceil((growth - ROUNDING) / STEP));
};

/** Whether a limit is one that the page finds, where nobody stated it. */
export const isFound = (limit: string, stated: readonly string[]): boolean =>
  /^fold=\+\d*0$/.test(limit) && !stated.includes(limit);

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
