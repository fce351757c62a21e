// SPDX-License-Identifier: MIT
// Where a plane at right angles to an axis cuts panels.

interface Panels {
  /** Of each panel into `vertices`, and the end. */
  readonly offsets: Int32Array;
  readonly vertices: Int32Array;
}

export interface PlaneSection {
  /** Two points (x, y, z each) a piece. */
  readonly pieces: Float64Array;
  /** How many panels it goes through. */
  readonly panels: number;
}

type Point = readonly [number, number, number];

/** Where the sides of one panel cross the plane, along the line in which it meets the panel. A corner
 * on the plane counts as above it, so that every side crosses or does not. */
function crossings(
  at: (k: number) => Point,
  count: number,
  axis: 0 | 1 | 2,
  height: number,
): Point[] {
  const found: Point[] = [];
  for (let k = 0; k < count; ++k) {
    const [a, b] = [at(k), at((k + 1) % count)];
    if (a[axis] >= height === b[axis] >= height) continue;
    const t = (height - a[axis]) / (b[axis] - a[axis]);
    const along = (c: 0 | 1 | 2): number => (c === axis ? height : a[c] + t * (b[c] - a[c]));
    found.push([along(0), along(1), along(2)]);
  }
  const [first, last] = [found[0], found.at(-1)];
  if (!first || !last) return found;
  // Of a panel that is not convex there are more than two; along the line every other piece is outside.
  const way = first.map((x, c) => (last[c] ?? 0) - x);
  const place = (p: Point): number => p.reduce((sum, x, c) => sum + x * (way[c] ?? 0), 0);
  return found.sort((p, q) => place(p) - place(q));
}

/** @param points three numbers a vertex */
export function cutPanels(
  points: ArrayLike<number>,
  { offsets, vertices }: Panels,
  axis: 0 | 1 | 2,
  height: number,
): PlaneSection {
  const pieces: number[] = [];
  let panels = 0;
  for (let f = 0; f + 1 < offsets.length; ++f) {
    const [begin, end] = [offsets[f] ?? 0, offsets[f + 1] ?? 0];
    const at = (k: number): Point => {
      const v = 3 * (vertices[begin + k] ?? 0);
      return [points[v] ?? 0, points[v + 1] ?? 0, points[v + 2] ?? 0];
    };
    const found = crossings(at, end - begin, axis, height);
    if (found.length > 0) ++panels;
    for (const point of found) pieces.push(...point);
  }
  return { pieces: Float64Array.from(pieces), panels };
}

/** Of all pieces together. */
export function sectionLength({ pieces }: PlaneSection): number {
  let length = 0;
  for (let k = 0; k + 5 < pieces.length; k += 6) {
    const [a, b] = [pieces.subarray(k, k + 3), pieces.subarray(k + 3, k + 6)];
    length += Math.hypot(...a.map((x, c) => x - (b[c] ?? 0)));
  }
  return length;
}
