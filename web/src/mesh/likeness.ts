// SPDX-License-Identifier: MIT
// Whether a mesh is another shape of one that was shown before, or that one cut.
import type { Polygons } from "./display-mesh.ts";

/** Display coordinates span 10: as far as a point may go and still be where the eye left it. */
const NEAR = 1.5;

const equal = (a: Int32Array, b: Int32Array): boolean =>
  a.length === b.length && a.every((value, k) => value === b[k]);

/** Whether faces are the same and no point is far from where it was: a view of the one suits the other. */
export function isSameStructure(before: Polygons, now: Polygons): boolean {
  const [from, to] = [before.display, now.display];
  if (from.length !== to.length) return false;
  if (!equal(before.offsets, now.offsets) || !equal(before.vertices, now.vertices)) return false;
  for (let k = 0; k < from.length; k += 3) {
    const gap = (c: number): number => (to[k + c] ?? 0) - (from[k + c] ?? 0);
    if (Math.hypot(gap(0), gap(1), gap(2)) > NEAR) return false;
  }
  return true;
}

/** Display coordinates: rounding, and what evening out takes. */
const SAME = 1e-4;

/** Whether points stand where they stood, and others may have come or gone at the end: as cuts leave them. */
export function hasSamePoints(before: Float32Array, now: Float32Array): boolean {
  const [fewer, more] = before.length < now.length ? [before, now] : [now, before];
  return fewer.length > 0 && fewer.every((x, k) => Math.abs(x - (more[k] ?? 0)) < SAME);
}
