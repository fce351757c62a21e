// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { measures } from "../../web/src/mesh/measuring.ts";
import type { Vector } from "../../web/src/mesh/vector.ts";

const named = (...points: Vector[]): Record<string, number> =>
  Object.fromEntries(measures(points).map(({ name, value }) => [name, value]));

it("two points: how far, in which direction, how steep", () => {
  expect(named([1, 1, 1], [4, 5, 1])).toMatchObject({
    Distance: 5,
    "In x": 3,
    "In y": 4,
    Slope: 0,
  });
  const down = { Slope: expect.closeTo(-45, 12), "In plan": 3 };
  expect(named([0, 0, 3], [3, 0, 0])).toMatchObject(down);
});

it("three points: the angle at the second, also where it is next to nothing or straight", () => {
  const angle = (c: Vector) => named([1, 0, 0], [0, 0, 0], c)["Angle at the second"];
  expect(angle([0, 2, 0])).toBeCloseTo(90, 12);
  expect(angle([5, 5e-9, 0])).toBeCloseTo((1e-9 * 180) / Math.PI, 15);
  expect(angle([-5, 0, 0])).toBe(180);
});

it("many points: their levels, their box and the way from one to the next", () => {
  expect(named([0, 0, 2], [0, 3, 2], [4, 3, 5], [4, 3, 4])).toEqual({
    Lowest: 2,
    Highest: 5,
    "Across x": 4,
    "Across y": 3,
    "Across z": 3,
    "Point to point": 9,
  });
  expect(measures([[1, 2, 3]])).toEqual([]);
});
