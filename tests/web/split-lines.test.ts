// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { addedSides } from "../../web/src/features/planarising/split-lines.ts";
import { buildTopology } from "../../web/src/mesh/topology.ts";

/** Two quads side by side: 0 1 2 over 3 4 5. */
const QUADS = [
  [0, 1, 4, 3],
  [1, 2, 5, 4],
] as const;

const topologyOf = (panels: readonly (readonly number[])[]) => {
  const ends = panels.map((_, k) => panels.slice(0, k + 1).flat().length);
  return buildTopology(Int32Array.from([0, ...ends]), Int32Array.from(panels.flat()), 6);
};

const opened = {
  topology: topologyOf(QUADS),
  report: { centre: [1, 0.5, 0], scale: 2 } as const,
};

/** The lower end has moved by a quarter. */
const positions = Float64Array.from([0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0.25, 2, 1, 0]);

it("the sides that a split adds are drawn where its points are", () => {
  const topology = topologyOf([
    [0, 1, 4],
    [1, 2, 5, 4],
    [0, 4, 3],
  ]);
  expect([...addedSides(opened, { positions, topology })]).toEqual([-2, -1, 0, 0, 1, 0.5]);
});

it("a mesh that is only moved has none", () => {
  expect(addedSides(opened, { positions, topology: topologyOf(QUADS) })).toHaveLength(0);
});
