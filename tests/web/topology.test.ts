// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import { buildTopology, row } from "../../web/src/mesh/topology.ts";
import { sensibleVertex } from "../../web/src/state/sensible-vertex.ts";

/** Two quads side by side: 0-1-2 above 3-4-5. */
const offsets = Int32Array.of(0, 4, 8);
const vertices = Int32Array.of(0, 1, 4, 3, 1, 2, 5, 4);

describe("topology", () => {
  const topology = buildTopology(offsets, vertices, 6);

  it("has every edge once", () => {
    expect(topology.edges.length / 2).toBe(7);
  });

  it("finds the corners of a vertex", () => {
    expect([...row(topology.corners, 1)]).toEqual([1, 4]);
    expect([...row(topology.corners, 5)]).toEqual([6]);
  });

  it("finds the edge ends of a vertex", () => {
    const neighbours = [...row(topology.edgeEnds, 4)].map((end) => topology.edges[end ^ 1]);
    expect(neighbours.sort()).toEqual([1, 3, 5]);
  });

  it("knows the boundary", () => {
    expect([...topology.boundary]).toEqual([1, 1, 1, 1, 1, 1]);
  });
});

describe("a sensible vertex", () => {
  const grid = Array.from({ length: 25 }, (_, k) => [k % 5, Math.floor(k / 5), 0]).flat();
  const boundary = Uint8Array.from({ length: 25 }, (_, k) =>
    k % 5 === 0 || k % 5 === 4 || k < 5 || k >= 20 ? 1 : 0,
  );

  it("is the middle at first", () => {
    expect(sensibleVertex(grid, boundary, [])).toBe(12);
  });

  it("is elsewhere then, never on the boundary, never a handle", () => {
    const second = sensibleVertex(grid, boundary, [12]);
    expect(second).not.toBe(12);
    expect(boundary[second ?? 0]).toBe(0);
  });

  it("is nothing when all are taken", () => {
    expect(sensibleVertex([0, 0, 0], Uint8Array.of(1), [0])).toBeNull();
  });
});
