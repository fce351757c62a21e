// SPDX-License-Identifier: MIT
// Panels as triangles over their own corners: a panel with n corners has n - 2 of them, always at
// the same place in the list, so that one panel can be cut anew when an edit makes it concave.
// From its own file: the worker must not carry the whole of three.
import { Earcut } from "three/src/extras/Earcut.js";

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

/** The two axes along which a polygon is seen from before; the one it faces most is left out. */
function axesOf(corners: Float32Array, begin: number, end: number): readonly [number, number] {
  const [x, y, z] = areaVector(corners, begin, end);
  const [ax, ay, az] = [Math.abs(x), Math.abs(y), Math.abs(z)];
  if (ax > ay && ax > az) return x < 0 ? [2, 1] : [1, 2];
  if (ay > az) return y < 0 ? [0, 2] : [2, 0];
  return z < 0 ? [1, 0] : [0, 1];
}

/** The first corner, from 0, that turns the other way than the polygon does; −1 if none does. */
function firstReflex(corners: Float32Array, begin: number, end: number): number {
  const [u, v] = axesOf(corners, begin, end);
  const along = (place: number, axis: number): number => corners[3 * place + axis] ?? 0;
  let before = end - 1;
  for (let at = begin; at < end; before = at++) {
    const after = at + 1 < end ? at + 1 : begin;
    const [x, y] = [along(at, u), along(at, v)];
    const turn =
      (x - along(before, u)) * (along(after, v) - y) -
      (y - along(before, v)) * (along(after, u) - x);
    if (turn < 0) return at - begin;
  }
  return -1;
}

/** The polygon as it is seen from before: x, y of its corners, one after the other. */
function flatten(corners: Float32Array, begin: number, end: number): number[] {
  const [u, v] = axesOf(corners, begin, end);
  const points: number[] = [];
  for (let c = begin; c < end; ++c) points.push(corners[3 * c + u] ?? 0, corners[3 * c + v] ?? 0);
  return points;
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
  const reflex = count === 3 ? -1 : firstReflex(corners, begin, end);
  let at = 3 * triangle;
  if (reflex < 0 || count === 4) {
    const first = Math.max(0, reflex);
    for (let k = 1; k + 1 < count; ++k) {
      out[at++] = begin + first;
      out[at++] = begin + ((first + k) % count);
      out[at++] = begin + ((first + k + 1) % count);
    }
  } else {
    // A polygon that crosses itself may give fewer triangles; the rest stay empty.
    out.fill(begin, at, at + 3 * (count - 2));
    const ears = Earcut.triangulate(flatten(corners, begin, end));
    for (const k of ears.slice(0, 3 * (count - 2))) out[at++] = begin + k;
  }
  return reflex >= 0;
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
