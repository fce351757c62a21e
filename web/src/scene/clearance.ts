// SPDX-License-Identifier: MIT
// Fits a subject into the view so that nothing laid over the view, such as the legend, covers it.
import { Vector3 } from "three";
import { type Margins, type Sight, type Standpoint, standpoint } from "./framing.ts";
import type { Box, Place } from "./picking.ts";

/** Pixels between the subject and what lies over the view. */
const GAP = 12;
/** Share of the view's height that may be given up for it. */
const MOST = 0.5;
/** Edges that are tried: of more than that, every so manieth. */
const TRIED = 10_000;
/** Halvings of a margin: to about two pixels. */
const HALVINGS = 6;

export interface Subject {
  /** Display coordinates. */
  readonly points: Float32Array;
  /** Two vertices per edge. */
  readonly edges: Int32Array;
}

/** The ends of enough of the edges, x, y, z each. */
function endsOf({ points, edges }: Subject): Float32Array {
  const count = edges.length / 2;
  const step = Math.max(1, Math.ceil(count / TRIED));
  const ends = new Float32Array(6 * Math.ceil(count / step));
  for (let k = 0; k * step < count; ++k) {
    const [a, b] = [3 * (edges[2 * k * step] ?? 0), 3 * (edges[2 * k * step + 1] ?? 0)];
    ends.set(points.subarray(a, a + 3), 6 * k);
    ends.set(points.subarray(b, b + 3), 6 * k + 3);
  }
  return ends;
}

/** Whether the line from `a` to `b` comes into the box: its shares within both strips meet. */
function enters(a: Place, b: Place, box: Box): boolean {
  let [from, to] = [0, 1];
  const strips = [
    [a.x, b.x, box.left - GAP, box.right + GAP],
    [a.y, b.y, box.top - GAP, box.bottom + GAP],
  ] as const;
  for (const [start, end, low, high] of strips) {
    // A line along the strip divides by zero: to infinities, which are right.
    const [one, other] = [(low - start) / (end - start), (high - start) / (end - start)];
    from = Math.max(from, Math.min(one, other));
    to = Math.min(to, Math.max(one, other));
  }
  return from <= to;
}

/** Whether no edge is under a box, seen from `position`. */
function isClear(
  ends: Float32Array,
  { position }: Standpoint,
  { right, above, towards, width, axis, slope }: Sight,
  boxes: readonly Box[],
): boolean {
  const arm = new Vector3();
  const onScreen = (k: number): Place => {
    arm.fromArray(ends, k).sub(position);
    const scale = -1 / (slope * arm.dot(towards));
    return { x: width / 2 + scale * arm.dot(right), y: axis - scale * arm.dot(above) };
  };
  for (let k = 0; k < ends.length; k += 6) {
    const [a, b] = [onScreen(k), onScreen(k + 3)];
    if (boxes.some((box) => enters(a, b, box))) return false;
  }
  return true;
}

/** The least margin on one side that keeps the boxes clear; null if even `most` does not. */
function leastMargin(most: number, clear: (margin: number) => boolean): number | null {
  if (!clear(most)) return null;
  let [tooLittle, enough] = [0, most];
  for (let k = 0; k < HALVINGS; ++k) {
    const middle = (tooLittle + enough) / 2;
    if (clear(middle)) enough = middle;
    else tooLittle = middle;
  }
  return enough;
}

/**
 * The nearest standpoint from which the subject fits below `top` pixels and lies under none of the
 * boxes, which stand in the lower corners: moved up or to the right as far as that takes.
 */
export function clearStandpoint(
  subject: Subject,
  sight: Sight,
  top: number,
  boxes: readonly Box[],
): Standpoint {
  const from = (points: Float32Array, margins: Partial<Margins>): Standpoint =>
    standpoint(points, sight, { left: 0, bottom: 0, top, ...margins });
  const ends = endsOf(subject);
  const clear = (margins: Partial<Margins>): boolean =>
    isClear(ends, from(ends, margins), sight, boxes);
  if (boxes.length === 0 || clear({})) return from(subject.points, {});
  const { width, height } = sight;
  const high = Math.max(...boxes.map((box) => height - box.top)) + GAP;
  const wide = Math.min(...boxes.map((box) => box.right)) + GAP;
  const most = Math.min(high, MOST * height);
  const bottom = leastMargin(most, (margin) => clear({ bottom: margin })) ?? most;
  const left = leastMargin(Math.min(wide, width / 2), (margin) => clear({ left: margin }));
  const away = (margins: Partial<Margins>): number => {
    const { position, target } = from(ends, margins);
    return position.distanceTo(target);
  };
  const aside = left !== null && away({ left }) < away({ bottom });
  return from(subject.points, aside ? { left } : { bottom });
}
