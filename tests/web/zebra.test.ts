// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { smoothNormals } from "../../web/src/features/analysis/zebra.ts";
import { buildTopology } from "../../web/src/mesh/topology.ts";

it("a ridge's points have the mean of both slopes by their areas, the others their own panel's", () => {
  // Two panels that meet along the y axis, the right one twice as wide.
  const points = [
    [-1, 0, -1],
    [0, 0, 0],
    [2, 0, -2],
    [-1, 1, -1],
    [0, 1, 0],
    [2, 1, -2],
  ];
  const offsets = Int32Array.of(0, 4, 8);
  const vertices = Int32Array.of(0, 1, 4, 3, 1, 2, 5, 4);
  const corners = Float32Array.from([...vertices].flatMap((v) => points[v] ?? []));
  const normals = new Float32Array(corners.length);
  smoothNormals(corners, offsets, buildTopology(offsets, vertices, points.length), normals);
  const at = (corner: number): number[] => [...normals.subarray(3 * corner, 3 * corner + 3)];
  const [half, ridge] = [Math.SQRT1_2, Math.hypot(1, 3)];
  for (const corner of [0, 3]) expect(at(corner)).toEqual([-half, 0, half].map(Math.fround));
  for (const corner of [5, 6]) expect(at(corner)).toEqual([half, 0, half].map(Math.fround));
  for (const corner of [1, 2, 4, 7]) {
    expect(at(corner)[0]).toBeCloseTo(1 / ridge, 6);
    expect(at(corner)[2]).toBeCloseTo(3 / ridge, 6);
  }
});
