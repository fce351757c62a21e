// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import { outlineOf, ringsWithin } from "../../web/src/mesh/reach.ts";
import { buildTopology } from "../../web/src/mesh/topology.ts";

/** `n` × `n` unit squares; point i, j has the number j · (n + 1) + i. */
function grid(n: number) {
  const side = n + 1;
  const display = new Float32Array(3 * side * side);
  for (let v = 0; v < side * side; ++v) display.set([v % side, Math.floor(v / side), 0], 3 * v);
  const faces = Array.from({ length: n * n }, (_, f) => {
    const a = Math.floor(f / n) * side + (f % n);
    return [a, a + 1, a + side + 1, a + side];
  });
  const offsets = Int32Array.from({ length: faces.length + 1 }, (_, f) => 4 * f);
  const vertices = Int32Array.from(faces.flat());
  return { display, offsets, vertices, topology: buildTopology(offsets, vertices, side * side) };
}

const middle = 5 * 11 + 5;
const mesh = grid(10);

describe("what a reach covers", () => {
  it("is as many face rings as it says", () => {
    const found = ringsWithin(mesh, [middle], { rings: 2, length: 0 });
    expect(found.size).toBe(25);
    expect(found.get(middle)).toBe(0);
    expect(found.get(middle + 11 + 1)).toBe(1);
    expect(found.get(middle - 2)).toBe(2);
  });

  it("ends at its length, straight from the nearest seed", () => {
    const found = ringsWithin(mesh, [middle], { rings: 0, length: 1.5 });
    expect(found.size).toBe(9);
    expect(ringsWithin(mesh, [middle, 0], { rings: 1, length: 1.2 }).size).toBe(5 + 3);
  });

  it("is everything without a limit, and nothing without a seed", () => {
    expect(ringsWithin(mesh, [0], { rings: 0, length: 0 }).size).toBe(121);
    expect(ringsWithin(mesh, [], { rings: 3, length: 0 }).size).toBe(0);
  });

  it("is bounded by the line around the panels that can change", () => {
    const ends = outlineOf(mesh, ringsWithin(mesh, [middle], { rings: 1, length: 0 }).keys());
    expect(ends.length / 2).toBe(16);
    for (const v of ends) {
      const far = Math.max(Math.abs((v % 11) - 5), Math.abs(Math.floor(v / 11) - 5));
      expect(far).toBe(2);
    }
    // At a corner of the mesh it follows the boundary.
    const corner = outlineOf(mesh, ringsWithin(mesh, [0], { rings: 1, length: 0 }).keys());
    expect(corner.length / 2).toBe(8);
  });
});
