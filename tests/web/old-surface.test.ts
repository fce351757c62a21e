// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import { type Motion, OldSurface } from "../../web/src/mesh/old-surface.ts";
import { buildTopology } from "../../web/src/mesh/topology.ts";
import { motionEnd } from "../../web/src/state/ramp-ends.ts";

/** Squares of side 1, `n` points a side, point n · j + i at (i, j, 0). */
function grid(n: number): OldSurface {
  const points = Array.from({ length: n * n }, (_, v) => [v % n, Math.floor(v / n), 0]).flat();
  const corners: number[] = [];
  for (let j = 0; j + 1 < n; ++j)
    for (let i = 0; i + 1 < n; ++i)
      corners.push(n * j + i, n * j + i + 1, n * (j + 1) + i + 1, n * (j + 1) + i);
  const vertices = Int32Array.from(corners);
  const offsets = Int32Array.from({ length: (n - 1) ** 2 + 1 }, (_, f) => 4 * f);
  const topology = buildTopology(offsets, vertices, n * n);
  return new OldSurface(points, { offsets, vertices, topology });
}

function expectMotion({ shape, slide }: Motion, height: number, along: number): void {
  expect(shape).toBeCloseTo(height, 12);
  expect(slide).toBeCloseTo(along, 12);
}

describe("a move off a plane", () => {
  const surface = grid(6);

  it("is its height, and the way along it", () => {
    expectMotion(surface.motion(14, [2, 2, 0.7]), 0.7, 0);
    expectMotion(surface.motion(14, [2.3, 2.4, -2]), -2, 0.5);
    expectMotion(surface.motion(14, [4.4, 3.8, 0]), 0, Math.hypot(2.4, 1.8));
  });

  it("goes on straight beyond the border", () => {
    expectMotion(surface.motion(0, [-3, 0, 4]), 4, 3);
    expectMotion(surface.motion(14, [2, -3, 0.1]), 0.1, 5);
  });
});

it("the ramp ends at the largest, on whichever side, and above rounding", () => {
  expect(motionEnd([0.2, -0.7, 0.1], 1)).toBe(0.7);
  expect(motionEnd([1e-9, -1e-9], 2)).toBe(2e-3);
  expect(motionEnd([], 0)).toBe(0);
});
