// SPDX-License-Identifier: MIT
// A finished design in display coordinates, from what the page itself keeps.
import type { OpenedMesh, Shape } from "./protocol.ts";

/** All points of a mesh, x, y, z each, as `shape` has them. */
export function displayOfShape({ report, display }: OpenedMesh, shape: Shape): Float32Array {
  const { centre, scale } = report;
  const points = display.slice();
  shape.moved.forEach((v, k) => {
    const at = (axis: 0 | 1 | 2) => ((shape.positions[3 * k + axis] ?? 0) - centre[axis]) * scale;
    points.set([at(0), at(1), at(2)], 3 * v);
  });
  return points;
}
