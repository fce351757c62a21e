// SPDX-License-Identifier: MIT
// The edges of some of the panels of a mesh.
import type { Faces } from "./point-frame.ts";
import { groupByKey, row, type Topology } from "./topology.ts";

/** The topology with only those edges that one of the panels `shown` has. */
export function edgesOfPanels(
  { offsets, vertices, topology }: Faces,
  shown: (panel: number) => boolean,
): Topology {
  const kept = new Uint8Array(topology.edges.length / 2);
  const edgeOf = (a: number, b: number): number | undefined =>
    row(topology.edgeEnds, a).find((end) => topology.edges[end ^ 1] === b);
  for (let panel = 0; panel + 1 < offsets.length; ++panel) {
    if (!shown(panel)) continue;
    const [begin, end] = [offsets[panel] ?? 0, offsets[panel + 1] ?? 0];
    for (let c = begin; c < end; ++c) {
      const found = edgeOf(vertices[c] ?? 0, vertices[c + 1 < end ? c + 1 : begin] ?? 0);
      if (found !== undefined) kept[found >> 1] = 1;
    }
  }
  const edges = topology.edges.filter((_, end) => kept[end >> 1] === 1);
  return { ...topology, edges, edgeEnds: groupByKey(edges, topology.boundary.length) };
}
