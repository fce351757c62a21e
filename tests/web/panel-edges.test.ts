// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { edgesOfPanels } from "../../web/src/mesh/panel-edges.ts";
import { buildTopology, row } from "../../web/src/mesh/topology.ts";

/** Two quads side by side, 0-1-2 above 3-4-5. */
const offsets = Int32Array.of(0, 4, 8);
const vertices = Int32Array.of(0, 1, 4, 3, 1, 2, 5, 4);
const mesh = { offsets, vertices, topology: buildTopology(offsets, vertices, 6) };

const pairs = (edges: Int32Array): string[] =>
  Array.from({ length: edges.length / 2 }, (_, k) =>
    [...edges.subarray(2 * k, 2 * k + 2)].join("-"),
  );

it("an edge is kept while one of its panels is", () => {
  const left = edgesOfPanels(mesh, (panel) => panel === 0);
  expect(pairs(left.edges).toSorted()).toEqual(["0-1", "0-3", "1-4", "3-4"]);
  expect(row(left.edgeEnds, 2).length).toBe(0);
  expect([...row(left.edgeEnds, 1)].map((end) => left.edges[end ^ 1]).toSorted()).toEqual([0, 4]);
  expect(edgesOfPanels(mesh, () => true).edges).toEqual(mesh.topology.edges);
  expect(edgesOfPanels(mesh, () => false).edges.length).toBe(0);
});
