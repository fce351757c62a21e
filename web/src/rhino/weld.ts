// SPDX-License-Identifier: MIT
// Points that are drawn once for each panel become one.
import type { Faces } from "./model.ts";

export interface Welded extends Faces {
  /** Points that took the place of another one that was not theirs to the last bit. */
  readonly moved: number;
  /** The longest such way, model units. */
  readonly largest: number;
  /** Faces of which fewer than three corners are left. */
  readonly collapsed: number;
}

/** The core's: of each point the number of the one whose place it takes, from 0 in the order of those
 * that keep theirs. @param within model units */
export type JoinPoints = (points: Float64Array, within: number) => Int32Array;

const pointAt = (points: Faces["points"], v: number): readonly [number, number, number] => [
  points[3 * v] ?? 0,
  points[3 * v + 1] ?? 0,
  points[3 * v + 2] ?? 0,
];

const between = (a: readonly number[], b: readonly number[]): number =>
  Math.hypot((a[0] ?? 0) - (b[0] ?? 0), (a[1] ?? 0) - (b[1] ?? 0), (a[2] ?? 0) - (b[2] ?? 0));

/** Of sides that have a length. */
function shortestSide({ points, faces }: Faces): number {
  let shortest = Number.POSITIVE_INFINITY;
  for (const face of faces)
    face.forEach((v, k) => {
      const side = between(pointAt(points, v), pointAt(points, face[(k + 1) % face.length] ?? 0));
      if (side > 0) shortest = Math.min(shortest, side);
    });
  return shortest;
}

/** `tolerance`, but at most a tenth of the shortest side, so that no side is lost. */
const safeTolerance = (mesh: Faces, tolerance: number): number =>
  Math.min(tolerance, shortestSide(mesh) / 10);

/** Each point takes the place of an earlier one within `tolerance` (model units) of it. */
export function weld(mesh: Faces, tolerance: number, join: JoinPoints): Welded {
  const places = join(Float64Array.from(mesh.points), safeTolerance(mesh, tolerance));
  const kept: number[] = [];
  let [moved, largest] = [0, 0];
  places.forEach((place, v) => {
    const at = pointAt(mesh.points, v);
    if (3 * place === kept.length) kept.push(...at);
    const off = between(at, pointAt(kept, place));
    if (off > 0) moved += 1;
    largest = Math.max(largest, off);
  });
  const faces = mesh.faces
    .map((face) => face.map((v) => places[v] ?? 0))
    .map((face) => face.filter((v, k) => v !== face[(k + 1) % face.length]));
  const whole = faces.filter((face) => face.length >= 3);
  const collapsed = faces.length - whole.length;
  return { points: kept, faces: whole, moved, largest, collapsed };
}
