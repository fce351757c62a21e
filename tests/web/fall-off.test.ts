// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { fallOffWeights, middleOf } from "../../web/src/mesh/fall-off.ts";
import type { Vector } from "../../web/src/mesh/vector.ts";

/** Points 1 apart on a line, the middle one at 0. */
const line: readonly Vector[] = [-3, -2, -1, 0, 1, 2, 3].map((x) => [x, 5, -2]);

it("without a fall-off all move alike, to the last bit", () => {
  expect(fallOffWeights(line, middleOf(line), 0, 1)).toEqual(line.map(() => 1));
});

it("the middle goes all the way, what lies further out less, and nothing not at all", () => {
  const weights = fallOffWeights(line, middleOf(line), 1, 1);
  expect(weights[3]).toBe(1);
  expect(weights[2]).toBeCloseTo(1 - (1 / 16) * (3 - 0.5), 12);
  expect(weights.toSorted((a, b) => a - b).slice(0, 2)).toEqual([weights[0], weights[6]]);
  expect(Math.min(...weights)).toBeGreaterThan(0);
  expect(weights).toEqual(weights.toReversed());
});

it("a smaller share leaves a plateau", () => {
  const weights = fallOffWeights(line, middleOf(line), 0.5, 1);
  expect(weights.slice(1, 6)).toEqual([1, 1, 1, 1, 1]);
  expect(weights[0]).toBeCloseTo(0.5, 12);
});

it("falls off from any of them, and points all as far from it move alike", () => {
  const from = fallOffWeights(line, line[0] ?? [0, 0, 0], 1, 1);
  expect(from).toEqual(from.toSorted((a, b) => b - a));
  expect(from[0]).toBe(1);
  const ring: readonly Vector[] = [
    [1, 0, 0],
    [0, 1, 0],
    [-1, 0, 0],
    [0, -1, 0],
  ];
  expect(fallOffWeights(ring, middleOf(ring), 1, 0.1)).toEqual([1, 1, 1, 1]);
  expect(fallOffWeights([[7, 7, 7]], [7, 7, 7], 1, 1)).toEqual([1]);
});
