// SPDX-License-Identifier: MIT
// Whether a finished edit, not a variation of it, leaves a point noticeably short of where it was asked to go.
import { type Design, leftBehind } from "./design.ts";

/** Share of the way. Soft handles stop short by a constant that the weights set, about a hundredth
 * of an edge, which is much of a short way. */
const NOTICEABLE = 0.5;

/** `base`: coordinates of all points before the edit. */
export function stopsShort(design: Design, base: Float64Array): boolean {
  if (leftBehind(design)) return false;
  const { handles, report } = design;
  if (report.status === "infeasible_handles") return true;
  const ways = handles
    .filter(({ pinned }) => !pinned)
    .map(({ vertex, target }) =>
      Math.hypot(...target.map((x, axis) => x - (base[3 * vertex + axis] ?? 0))),
    );
  const longest = Math.max(0, ...ways);
  return longest > 0 && report.handleError > NOTICEABLE * longest;
}
