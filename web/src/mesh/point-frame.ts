// SPDX-License-Identifier: MIT
// Directions that belong to a point of a mesh: two along its surface and one out of it.
import { row, type Topology } from "./topology.ts";
import { panelAt } from "./triangulation.ts";
import { add, cross, dot, minus, type Vector } from "./vector.ts";

/** Three unit vectors at right angles, right-handed: along × across = normal. */
export interface Frame {
  readonly along: Vector;
  readonly across: Vector;
  readonly normal: Vector;
}

export interface Faces {
  readonly offsets: Int32Array;
  readonly vertices: Int32Array;
  readonly topology: Topology;
}

const unit = (a: Vector): Vector | null => {
  const length = Math.hypot(...a);
  return length > 0 ? [a[0] / length, a[1] / length, a[2] / length] : null;
};

/** The area vectors of the panels at a point, added up; upwards if there is no area. */
function normalAt(faces: Faces, at: (vertex: number) => Vector, vertex: number): Vector {
  const { offsets, vertices, topology } = faces;
  let sum: Vector = [0, 0, 0];
  for (const corner of row(topology.corners, vertex)) {
    const f = panelAt(offsets, corner);
    const [begin, end] = [offsets[f] ?? 0, offsets[f + 1] ?? 0];
    for (let c = begin; c < end; ++c) {
      const next = c + 1 < end ? c + 1 : begin;
      // Relative to the point itself: far from the origin the areas would drown in rounding.
      const here = minus(at(vertices[c] ?? 0), at(vertex));
      const there = minus(at(vertices[next] ?? 0), at(vertex));
      sum = add(sum, cross(here, there));
    }
  }
  return unit(sum) ?? [0, 0, 1];
}

/**
 * The frame at a point. `along` follows the edge that runs most nearly along X, towards +X, bent
 * into the surface; `at` gives the place of a vertex.
 */
export function pointFrame(faces: Faces, at: (vertex: number) => Vector, vertex: number): Frame {
  const normal = normalAt(faces, at, vertex);
  const { edges, edgeEnds } = faces.topology;
  let along: Vector | null = null;
  let best = 0;
  for (const end of row(edgeEnds, vertex)) {
    const edge = minus(at(edges[end ^ 1] ?? vertex), at(vertex));
    const flat = unit(add(edge, normal, -dot(edge, normal)));
    if (flat && Math.abs(flat[0]) > best) {
      best = Math.abs(flat[0]);
      along = flat[0] < 0 ? [-flat[0], -flat[1], -flat[2]] : flat;
    }
  }
  const axis: Vector = Math.abs(normal[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
  along ??= unit(add(axis, normal, -dot(axis, normal))) ?? [1, 0, 0];
  return { along, across: cross(normal, along), normal };
}
