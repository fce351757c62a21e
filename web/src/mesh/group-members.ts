// SPDX-License-Identifier: MIT
// The panels of a set of points, and the points of a set of panels.
import type { DisplayMesh } from "./display-mesh.ts";
import { row } from "./topology.ts";
import { panelAt } from "./triangulation.ts";

/** All corners of panels, ascending. */
export function cornersOf({ offsets, vertices }: DisplayMesh, panels: readonly number[]): number[] {
  const corners = panels.flatMap((panel) => [
    ...vertices.subarray(offsets[panel] ?? 0, offsets[panel + 1] ?? 0),
  ]);
  return [...new Set(corners)].sort((a, b) => a - b);
}

/** The panels that have all their corners among points, or where none has, those at them; ascending. */
export function panelsOf(mesh: DisplayMesh, points: readonly number[]): number[] {
  const { offsets, vertices, topology } = mesh;
  const chosen = new Set(points);
  const touched = new Set(
    points.flatMap((v) => [...row(topology.corners, v)].map((corner) => panelAt(offsets, corner))),
  );
  const whole = [...touched].filter((panel) =>
    vertices
      .subarray(offsets[panel] ?? 0, offsets[panel + 1] ?? 0)
      .every((vertex) => chosen.has(vertex)),
  );
  return (whole.length > 0 ? whole : [...touched]).sort((a, b) => a - b);
}
