// SPDX-License-Identifier: MIT
// What a view of what is selected has to hold.

import { row } from "../mesh/topology.ts";
import type { Page } from "../state/page.ts";
import type { Subject } from "./clearance.ts";
import type { Shell } from "./shell.ts";

type Drawn = Pick<Shell, "current" | "topology" | "corners" | "offsets">;

/** The edges at the selected points, or around the selected panel; null if nothing is selected. One point alone
 * is seen with two panels on each side: half of one would fill the window. */
export function chosenOf(page: Page, shell: Drawn): Subject | null {
  const [chosen, panel] = [page.selection.value, page.selectedPanel.value];
  if (chosen.length > 0)
    return edgesAt(shell, chosen.length === 1 ? withNeighbours(shell, chosen) : chosen);
  return panel === null ? null : edgesAround(shell, panel);
}

function withNeighbours({ topology }: Drawn, vertices: readonly number[]): readonly number[] {
  const ends = vertices.flatMap((v) => [...row(topology.edgeEnds, v)]);
  return [...vertices, ...ends.map((end) => topology.edges[end ^ 1] ?? 0)];
}

function edgesAt({ current, topology }: Drawn, vertices: readonly number[]): Subject {
  const ends = vertices.flatMap((v) => [...row(topology.edgeEnds, v)]);
  const edges = ends.flatMap((end) => [end, end ^ 1]).map((end) => topology.edges[end] ?? 0);
  const points = edges.flatMap((v) => [...current.subarray(3 * v, 3 * v + 3)]);
  return { points: Float32Array.from(points), edges: Int32Array.from(edges.keys()) };
}

function edgesAround({ corners, offsets }: Drawn, panel: number): Subject {
  const points = corners.slice(3 * (offsets[panel] ?? 0), 3 * (offsets[panel + 1] ?? 0));
  const ends = Array.from({ length: points.length / 3 - 1 }, (_, k) => [k, k + 1]);
  return { points, edges: Int32Array.from(ends.flat()) };
}
