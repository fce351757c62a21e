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

describe("topology of panels thrown together", () => {
  /** The n-th of a sequence that looks random, 0 … below. */
  const pick = (n: number, below: number): number => Math.floor((n * 0.618034 * below) % below);
  const count = 40;
  const panels = Array.from({ length: 60 }, (_, f) =>
    Array.from(
      { length: 3 + (f % 4) },
      (_, c) => (pick(7 * f + 1, count) + c * (1 + (f % 5))) % count,
    ),
  );
  const starts = [0];
  for (const panel of panels) starts.push((starts.at(-1) ?? 0) + panel.length);
  const topology = buildTopology(Int32Array.from(starts), Int32Array.from(panels.flat()), count);
  const uses = new Map<string, number>();
  for (const panel of panels) {
    panel.forEach((a, k) => {
      const b = panel[(k + 1) % panel.length] ?? a;
      const key = `${Math.min(a, b)} ${Math.max(a, b)}`;
      uses.set(key, (uses.get(key) ?? 0) + 1);
    });
  }
  const pairs = Array.from({ length: topology.edges.length / 2 }, (_, e) => [
    topology.edges[2 * e] ?? 0,
    topology.edges[2 * e + 1] ?? 0,
  ]);

  it("has the edges of its panels, each once, by their ends", () => {
    expect(pairs.map((pair) => pair.join(" ")).sort()).toEqual([...uses.keys()].sort());
    const inOrder = [...pairs].sort(([a = 0, b = 0], [c = 0, d = 0]) => a - c || b - d);
    expect(pairs).toEqual(inOrder);
  });

  it("has a boundary where an edge is used once, however often others are", () => {
    const open = new Set([...uses].filter(([, n]) => n === 1).flatMap(([key]) => key.split(" ")));
    expect([...uses.values()].some((n) => n > 2)).toBe(true);
    expect(open.size).toBeLessThan(count);
    expect([...topology.boundary]).toEqual(
      Array.from({ length: count }, (_, v) => (open.has(String(v)) ? 1 : 0)),
    );
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

  it("is the best one that can be seen; the best one where none can", () => {
    const twoSkins = [...grid, ...grid.map((x, k) => (k % 3 === 2 ? x + 1 : x))];
    const sides = Uint8Array.of(...boundary, ...boundary);
    expect(sensibleVertex(twoSkins, sides, [])).toBe(12);
    expect(sensibleVertex(twoSkins, sides, [], (vertex) => vertex >= 25)).toBe(37);
    expect(sensibleVertex(twoSkins, sides, [], () => false)).toBe(12);
  });

  it("is nothing when all are taken", () => {
    expect(sensibleVertex([0, 0, 0], Uint8Array.of(1), [0])).toBeNull();
  });
});
