// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { buildTopology } from "../../web/src/mesh/topology.ts";
import { edgeInk, INK, meanEdge } from "../../web/src/scene/edge-lines.ts";

it("leaves out edges shorter than a pixel and draws those of three in full ink", () => {
  expect([0.5, 1, 2, 3, 40].map(edgeInk)).toEqual([0, 0, INK / 2, INK, INK]);
});

it("takes the mean over the edges of a strip of many panels, 3 long and 4 wide", () => {
  const panels = 2000;
  const points = new Float32Array(
    Array.from({ length: panels + 1 }, (_, k) => [3 * k, 0, 0, 3 * k, 4, 0]).flat(),
  );
  const offsets = Int32Array.from({ length: panels + 1 }, (_, f) => 4 * f);
  const vertices = Int32Array.from(
    Array.from({ length: panels }, (_, f) => [2 * f, 2 * f + 2, 2 * f + 3, 2 * f + 1]).flat(),
  );
  const mean = meanEdge(buildTopology(offsets, vertices, 2 * panels + 2), points);
  // Two sides of 3 and one of 4 per panel; a thousand of the six thousand edges are looked at.
  expect(mean).toBeGreaterThanOrEqual(3);
  expect(mean).toBeLessThanOrEqual(4);
  const all = meanEdge(
    buildTopology(offsets.slice(0, 101), vertices.slice(0, 400), 2 * panels + 2),
    points,
  );
  expect(all).toBeCloseTo((200 * 3 + 101 * 4) / 301, 6);
});
