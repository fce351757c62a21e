// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { furthestBetween, signOf } from "../../web/src/features/exploring/furthest.ts";
import type { Shape } from "../../web/src/solver/protocol.ts";

const shape = (points: Readonly<Record<number, readonly number[]>>): Shape => ({
  moved: Int32Array.from(Object.keys(points), Number),
  positions: Float64Array.from(Object.values(points).flat()),
});

const base = Float64Array.from([0, 0, 0, 1, 0, 0, 2, 0, 0]);

it("two shapes differ most at one point, also where only one of them moves it", () => {
  const edit = shape({ 1: [1, 0, 0.5] });
  expect(furthestBetween(edit, shape({ 1: [1, 0, 0.75], 2: [2, 0, -1] }), base)).toEqual({
    vertex: 2,
    move: [0, 0, -1],
  });
  expect(furthestBetween(edit, shape({}), base)).toEqual({ vertex: 1, move: [0, 0, -0.5] });
  expect(furthestBetween(edit, edit, base)).toBeNull();
});

it("the sign is that of the direction that a move follows most", () => {
  const frame = { normal: [0, 0, 1], along: [1, 0, 0], across: [0, 1, 0] } as const;
  expect(signOf([0.1, 0, -0.2], frame)).toBe("−");
  expect(signOf([0.1, 0, 0.2], frame)).toBe("+");
  expect(signOf([-0.3, 0, 0.2], frame)).toBe("−");
});
