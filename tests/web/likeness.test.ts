// SPDX-License-Identifier: MIT
// Which meshes may be shown from where the one before was seen.
import { expect, it } from "vitest";
import type { Polygons } from "../../web/src/mesh/display-mesh.ts";
import { hasSamePoints, isSameStructure } from "../../web/src/mesh/likeness.ts";

/** Two quads beside each other, 10 long. */
const pair: Polygons = {
  display: Float32Array.of(-5, -2, 0, 0, -2, 0, 5, -2, 0, -5, 2, 0, 0, 2, 0, 5, 2, 0),
  offsets: Int32Array.of(0, 4, 8),
  vertices: Int32Array.of(0, 1, 4, 3, 1, 2, 5, 4),
};

const raised = (by: number): Polygons => {
  const display = pair.display.slice();
  display[5] = by;
  return { ...pair, display };
};

it("a mesh little changed is the same structure", () => {
  expect(isSameStructure(pair, pair)).toBe(true);
  expect(isSameStructure(pair, raised(1.4))).toBe(true);
});

it("one with a point far off is not", () => {
  expect(isSameStructure(pair, raised(1.6))).toBe(false);
  expect(isSameStructure(raised(1.6), pair)).toBe(false);
});

it("nor are other faces on the same points, or more points", () => {
  const others = Int32Array.of(0, 1, 4, 3, 1, 2, 4, 5);
  expect(isSameStructure(pair, { ...pair, vertices: others })).toBe(false);
  expect(isSameStructure(pair, { ...pair, offsets: Int32Array.of(0, 3, 8) })).toBe(false);
  const display = Float32Array.of(...pair.display, 0, 0, 0);
  expect(isSameStructure(pair, { ...pair, display })).toBe(false);
});

it("keeps its points under cuts, which add some at the end", () => {
  const before = Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0);
  const cut = Float32Array.of(...before, 0.5, 0, 0);
  expect(hasSamePoints(before, cut)).toBe(true);
  expect(hasSamePoints(cut, before)).toBe(true);
  expect(hasSamePoints(before, Float32Array.of(0, 0, 0, 1.1, 0, 0, 1, 1, 0))).toBe(false);
  expect(hasSamePoints(new Float32Array(0), before)).toBe(false);
});
