// SPDX-License-Identifier: MIT
// Panels as triangles over their own corners: a panel with n corners has n - 2 of them, always at
// the same place in the list, so that one panel can be cut anew when an edit makes it concave.
// From its own file: the worker must not carry the whole of three.
import { Earcut } from "three/src/extras/Earcut.js";

interface Corner {
  readonly x: number;
  readonly y: number;
}

/** Where the triangles of panel `f` begin, in triangles. */
export const firstTriangle = (offsets: Int32Array, f: number): number => (offsets[f] ?? 0) - 2 * f;

/** The panel that a place in the face list belongs to. */
export function panelAt(offsets: Int32Array, corner: number): number {
  let low = 0;
  let high = offsets.length - 2;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if ((offsets[middle] ?? 0) <= corner) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** Twice the area vector of the polygon with corners `begin` … `end` (Newell). */
export function areaVector(
  corners: Float32Array,
  begin: number,
  end: number,
): [number, number, number] {
  let [x, y, z] = [0, 0, 0];
  for (let c = begin; c < end; ++c) {
    const a = 3 * c;
    const b = 3 * (c + 1 < end ? c + 1 : begin);
    const [ax, ay, az] = [corners[a] ?? 0, corners[a + 1] ?? 0, corners[a + 2] ?? 0];
    const [bx, by, bz] = [corners[b] ?? 0, corners[b + 1] ?? 0, corners[b + 2] ?? 0];
    x += (ay - by) * (az + bz);
    y += (az - bz) * (ax + bx);
    z += (ax - bx) * (ay + by);
  }
  return [x, y, z];
}

/** The polygon seen along its area vector, dropping the axis it points along most. */
function flatten(corners: Float32Array, begin: number, end: number): Corner[] {
  const normal = areaVector(corners, begin, end);
  const size = normal.map(Math.abs) as [number, number, number];
  const drop = size[0] > size[1] && size[0] > size[2] ? 0 : size[1] > size[2] ? 1 : 2;
  const [u, v] = [(drop + 1) % 3, (drop + 2) % 3];
  const flip = (normal[drop] ?? 0) < 0 ? -1 : 1;
  const points: Corner[] = [];
  for (let c = begin; c < end; ++c) {
    points.push({ x: flip * (corners[3 * c + u] ?? 0), y: corners[3 * c + v] ?? 0 });
  }
  return points;
}

/** Corners that turn the other way than the polygon does. */
function reflexCorners(points: readonly Corner[]): number[] {
  const reflex: number[] = [];
  points.forEach((at, k) => {
    const before = points[(k + points.length - 1) % points.length] ?? at;
    const after = points[(k + 1) % points.length] ?? at;
    const turn = (at.x - before.x) * (after.y - at.y) - (at.y - before.y) * (after.x - at.x);
    if (turn < 0) reflex.push(k);
  });
  return reflex;
}

/** Writes the triangles of one panel to `out`; true if it is concave. */
export function triangulatePanel(
  corners: Float32Array,
  begin: number,
  end: number,
  out: Uint32Array,
  triangle: number,
): boolean {
  const count = end - begin;
  let at = 3 * triangle;
  const fan = (first: number): void => {
    for (let k = 1; k + 1 < count; ++k) {
      out[at++] = begin + first;
      out[at++] = begin + ((first + k) % count);
      out[at++] = begin + ((first + k + 1) % count);
    }
  };
  if (count === 3) {
    fan(0);
    return false;
  }
  const points = flatten(corners, begin, end);
  const reflex = reflexCorners(points);
  if (reflex.length === 0) fan(0);
  else if (count === 4) fan(reflex[0] ?? 0);
  else {
    // A polygon that crosses itself may give fewer triangles; the rest stay empty.
    out.fill(begin, at, at + 3 * (count - 2));
    const ears = Earcut.triangulate(points.flatMap(({ x, y }) => [x, y]));
    for (const k of ears.slice(0, 3 * (count - 2))) out[at++] = begin + k;
  }
  return reflex.length > 0;
}

/** Every panel; `corners` holds x, y, z for every place in the face list. */
export function triangulate(corners: Float32Array, offsets: Int32Array): Uint32Array {
  const panels = offsets.length - 1;
  const triangles = new Uint32Array(3 * Math.max(0, firstTriangle(offsets, panels)));
  for (let f = 0; f < panels; ++f) {
    const begin = offsets[f] ?? 0;
    triangulatePanel(corners, begin, offsets[f + 1] ?? begin, triangles, firstTriangle(offsets, f));
  }
  return triangles;
}
