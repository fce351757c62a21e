// SPDX-License-Identifier: MIT
// Limits that an edit gets unasked, where they cost its handles nothing: on folds, where it folds panels
// sharply though it need not, and on corners, where it makes slivers though it need not.

import { buildableCorners } from "virtual:core-defaults";
import type { ShapeReport } from "./protocol.ts";

/** Degrees by which folds may sharpen: a limit is tried at each, the first that takes nothing stands. */
export const FAIR_STEPS: readonly number[] = [10, 20];
/** Of the limits that the page finds itself, all are multiples of it. */
const STEP = 10;
/** Degrees by which a fold at a limit may seem to exceed it. */
const ROUNDING = 0.01;
/** Share of the way to the targets that handles may lose by it. */
const LOSS = 0.05;

/** How many degrees the fold that sharpened most became sharper. */
export const foldGrowth = ({ sharpestFold: fold }: ShapeReport): number =>
  fold ? (fold.growth ?? fold.after - fold.before) : 0;

/** Degrees: of the limits that the page finds the first that folds grown by as much keep. */
export const stepOf = (growth: number): number =>
  STEP * Math.max(1, Math.ceil((growth - ROUNDING) / STEP));

/** Whether a limit is one that the page finds, where nobody stated it. */
export const isFound = (limit: string, stated: readonly string[]): boolean =>
  (limit === buildableCorners || /^fold=\+\d*0$/.test(limit)) && !stated.includes(limit);

/** Makes the edit with one more limit. */
export type LimitedEdit = (limit: string) => ShapeReport;

/** Whether handles get about as far with a limit as in `free`, the edit without it. @param way see foldLimit() */
const costsNothing = (free: ShapeReport, way: number, limited: ShapeReport): boolean =>
  limited.movedVertices > 0 &&
  limited.status !== "infeasible_handles" &&
  limited.handleError <= free.handleError + LOSS * way;

/**
 * The limit on folds with which the handles get as far as in `free`, the edit without one; null where none is
 * needed, or none of those tried lets them. The last edit that was made is the one that stands, unless
 * the result is null and edits were made.
 * @param way of the handle that goes furthest, from the base to its target; model units
 */
export function foldLimit(free: ShapeReport, way: number, edit: LimitedEdit): string | null {
  const growth = foldGrowth(free);
  for (const degrees of FAIR_STEPS.filter((step) => step < growth)) {
    const limit = `fold=+${degrees}`;
    if (costsNothing(free, way, edit(limit))) return limit;
  }
  return null;
}

/** An edit, and how many panels became slivers by it. */
export interface Counted {
  readonly report: ShapeReport;
  readonly slivers: number;
}

/**
 * As foldLimit(), on corners: null as well where the edit with it makes slivers, too, or folds more sharply
 * than `free` and than is fair.
 */
export function cornerLimit(
  free: Counted,
  way: number,
  edit: (limit: string) => Counted,
): string | null {
  if (free.slivers === 0) return null;
  const { report, slivers } = edit(buildableCorners);
  const fair = Math.max(foldGrowth(free.report), FAIR_STEPS[0] ?? 0);
  const isFair = foldGrowth(report) <= fair + ROUNDING;
  return slivers === 0 && isFair && costsNothing(free.report, way, report)
    ? buildableCorners
    : null;
}
