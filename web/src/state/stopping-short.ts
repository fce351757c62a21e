// SPDX-License-Identifier: MIT
// Whether a point stops noticeably short of where it was asked to go, by an edit, not a variation of it.
import { noticeableShare } from "virtual:core-defaults";
import { type Design, leftBehind } from "../design/design.ts";

/** Mean edges: a short way's share is not seen. */
const SEEN = 0.03;

/** Lengths in model units. */
export const isNoticeable = (short: number, way: number, meanEdge: number): boolean =>
  short > noticeableShare * way && short > SEEN * meanEdge;

/** `base`: coordinates of all points before the edit. */
export function stopsShort(design: Design, base: Float64Array, meanEdge: number): boolean {
  if (leftBehind(design)) return false;
  const { handles, report } = design;
  if (report.status === "infeasible_handles") return true;
  const ways = handles
    .filter(({ pinned }) => !pinned)
    .map(({ vertex, target }) =>
      Math.hypot(...target.map((x, axis) => x - (base[3 * vertex + axis] ?? 0))),
    );
  return isNoticeable(report.handleError, Math.max(0, ...ways), meanEdge);
}
