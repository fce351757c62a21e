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

/** Points by the cell of a grid that they are in; cells of one number are told apart by distance. */
class Grid {
  readonly #cells = new Map<number, number[]>();
  readonly #size: number;

  constructor(size: number) {
    this.#size = size;
  }

  #cell(x: number, y: number, z: number): number {
    return (Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791)) >>> 0;
  }

  add(point: number, at: readonly number[]): void {
    const [x = 0, y = 0, z = 0] = at.map((c) => Math.floor(c / this.#size));
    const cell = this.#cell(x, y, z);
    const there = this.#cells.get(cell);
    if (there) there.push(point);
    else this.#cells.set(cell, [point]);
  }

  /** Points in the cells around `at`, and maybe others. */
  *near(at: readonly number[]): Iterable<number> {
    const [x = 0, y = 0, z = 0] = at.map((c) => Math.floor(c / this.#size));
    for (let i = -1; i <= 1; ++i)
      for (let j = -1; j <= 1; ++j)
        for (let k = -1; k <= 1; ++k) yield* this.#cells.get(this.#cell(x + i, y + j, z + k)) ?? [];
  }
}

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

/** Never above a tenth of the shortest side, so that no side is lost. */
const safeTolerance = (mesh: Faces, tolerance: number): number => {
  const least = Number.MIN_VALUE; // the same point only
  return Math.max(Math.min(tolerance, shortestSide(mesh) / 10), least);
};

/** Each point takes the place of the first one within `tolerance` (model units) of it. */
export function weld(mesh: Faces, tolerance: number): Welded {
  const reach = safeTolerance(mesh, tolerance);
  const grid = new Grid(Math.max(reach, 1e-12));
  const kept: number[] = [];
  let [moved, largest] = [0, 0];
  const places = new Int32Array(mesh.points.length / 3).map((_, v) => {
    const at = pointAt(mesh.points, v);
    for (const other of grid.near(at)) {
      const off = between(at, pointAt(kept, other));
      if (off > reach) continue;
      if (off > 0) moved += 1;
      largest = Math.max(largest, off);
      return other;
    }
    grid.add(kept.length / 3, at);
    kept.push(...at);
    return kept.length / 3 - 1;
  });
  const faces = mesh.faces
    .map((face) => face.map((v) => places[v] ?? 0))
    .map((face) => face.filter((v, k) => v !== face[(k + 1) % face.length]));
  const whole = faces.filter((face) => face.length >= 3);
  const collapsed = faces.length - whole.length;
  return { points: kept, faces: whole, moved, largest, collapsed };
}
