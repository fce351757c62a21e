// SPDX-License-Identifier: MIT
// Where two shapes of a mesh differ most, and which way; how far one is from the mesh itself.

import type { Point } from "../../design/design.ts";
import type { Frame } from "../../mesh/point-frame.ts";
import { dot } from "../../mesh/vector.ts";
import type { Shape } from "../../solver/protocol.ts";

export interface Furthest {
  readonly vertex: number;
  /** From the one shape to the other, model units. */
  readonly move: Point;
}

const placesOf = ({ moved, positions }: Shape): ReadonlyMap<number, Point> =>
  new Map(
    Array.from(moved, (v, k) => {
      const [x = 0, y = 0, z = 0] = positions.subarray(3 * k, 3 * k + 3);
      return [v, [x, y, z]];
    }),
  );

/** null where the shapes are the same. `base`: model coordinates of every vertex. */
export function furthestBetween(from: Shape, to: Shape, base: Float64Array): Furthest | null {
  const [before, after] = [placesOf(from), placesOf(to)];
  let [found, most]: [Furthest | null, number] = [null, 0];
  for (const vertex of new Set([...before.keys(), ...after.keys()])) {
    const [x = 0, y = 0, z = 0] = base.subarray(3 * vertex, 3 * vertex + 3);
    const [a, b] = [before.get(vertex) ?? [x, y, z], after.get(vertex) ?? [x, y, z]];
    const move: Point = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    const length = Math.hypot(...move);
    if (length > most) [found, most] = [{ vertex, move }, length];
  }
  return found;
}

/** "+" or "−", by the direction of the surface that a move follows most: out of it, or along it. */
export function signOf(move: Point, { normal, along, across }: Frame): string {
  const parts = [normal, along, across].map((direction) => dot(move, direction));
  const lead = parts.reduce((a, b) => (Math.abs(b) > Math.abs(a) ? b : a));
  return lead < 0 ? "−" : "+";
}

/** How far the point moves that moves most, model units. */
export function reachOf({ moved, positions }: Shape, base: Float64Array): number {
  let largest = 0;
  moved.forEach((v, k) => {
    const gap = (c: number): number => (positions[3 * k + c] ?? 0) - (base[3 * v + c] ?? 0);
    largest = Math.max(largest, Math.hypot(gap(0), gap(1), gap(2)));
  });
  return largest;
}
