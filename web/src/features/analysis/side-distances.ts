// SPDX-License-Identifier: MIT
// How far the corners of panels are from the lines of their panel's sides. In a panel that is flat this is
// linear, so that what is between corners is interpolated exactly.
import { cross, dot, minus, type Vector } from "../../mesh/vector.ts";

/** Where there is no side, or one whose line cuts through its panel: farther than any frame is wide. */
export const NO_SIDE = 1e3;

const MOST_SIDES = 8;

/** Distances kept of every corner: 4 where no panel has more sides, else 8; those beyond are left out. */
export function sidesKept(offsets: Int32Array): 4 | 8 {
  for (let f = 0; f + 1 < offsets.length; ++f)
    if ((offsets[f + 1] ?? 0) - (offsets[f] ?? 0) > 4) return MOST_SIDES;
  return 4;
}

/** The area vector, twice. */
const normalOf = (points: readonly Vector[]): Vector => {
  const [first = [0, 0, 0] as const] = points;
  return points.reduce<Vector>(
    (sum, point, k) => {
      const next = points[(k + 1) % points.length] ?? point;
      const part = cross(minus(point, first), minus(next, first));
      return [sum[0] + part[0], sum[1] + part[1], sum[2] + part[2]];
    },
    [0, 0, 0],
  );
};

/** Of every point from the line of side `k`, inwards. */
function fromSide(points: readonly Vector[], normal: Vector, k: number): number[] {
  const from = points[k] ?? [0, 0, 0];
  const inwards = cross(normal, minus(points[(k + 1) % points.length] ?? from, from));
  const length = Math.hypot(...inwards) || 1;
  const all = points.map((point) => dot(minus(point, from), inwards) / length);
  const farthest = Math.max(...all);
  return Math.min(...all) < -0.01 * farthest ? all.map(() => NO_SIDE) : all;
}

/** Into `out`, `kept` for every corner; `corners` in the order of `offsets`. */
export function writeSideDistances(
  corners: Float32Array,
  offsets: Int32Array,
  kept: number,
  out: Float32Array,
): void {
  out.fill(NO_SIDE);
  for (let f = 0; f + 1 < offsets.length; ++f) {
    const [begin, end] = [offsets[f] ?? 0, offsets[f + 1] ?? 0];
    const points: Vector[] = [];
    for (let c = 3 * begin; c < 3 * end; c += 3)
      points.push([corners[c] ?? 0, corners[c + 1] ?? 0, corners[c + 2] ?? 0]);
    const normal = normalOf(points);
    for (let k = 0; k < Math.min(kept, points.length); ++k) {
      const all = fromSide(points, normal, k);
      all.forEach((distance, corner) => {
        out[kept * (begin + corner) + k] = distance;
      });
    }
  }
}

/** The mean length of the sides of panels. */
export function meanSide(corners: Float32Array, offsets: Int32Array): number {
  let sum = 0;
  for (let f = 0; f + 1 < offsets.length; ++f) {
    const [begin, end] = [offsets[f] ?? 0, offsets[f + 1] ?? 0];
    for (let k = begin; k < end; ++k) {
      const next = k + 1 < end ? k + 1 : begin;
      const along = (axis: number): number =>
        (corners[3 * next + axis] ?? 0) - (corners[3 * k + axis] ?? 0);
      sum += Math.hypot(along(0), along(1), along(2));
    }
  }
  return sum / Math.max(1, corners.length / 3);
}
