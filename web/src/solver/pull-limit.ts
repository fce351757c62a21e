// SPDX-License-Identifier: MIT
// What the page says of the limit of a drag; how that acts is the core's (planish/edit/pull_hold.hpp).
import { foldGrowth } from "./found-limits.ts";
import type { HandleList, PullLimit, ShapeReport } from "./protocol.ts";

/** The limit on folds that acts on the drag alone; null: none. */
export const ownBound = ({ degrees }: PullLimit): string | null =>
  degrees < Number.POSITIVE_INFINITY ? `fold=+${degrees}` : null;

/** The way of the handle that goes furthest from its base. */
export function longestWay(base: HandleList, handles: HandleList): number {
  let longest = 0;
  for (let k = 0; k < handles.length; k += 4) {
    const way = [1, 2, 3].map((axis) => (handles[k + axis] ?? 0) - (base[k + axis] ?? 0));
    longest = Math.max(longest, Math.hypot(...way));
  }
  return longest;
}

/** Whether an edit without the drag's own limit keeps it. */
export const keepsOwn = ({ degrees }: PullLimit, report: ShapeReport): boolean =>
  foldGrowth(report) <= degrees;
