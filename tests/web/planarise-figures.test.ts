// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import {
  shapeOf,
  sharpestFold,
  usualFold,
} from "../../web/src/features/planarising/planarise-preview.ts";
import { ShownStops } from "../../web/src/features/planarising/shown-stops.ts";

it("a place of the slider is the same as another that showed the same points, as they were last", () => {
  const stops = new ShownStops();
  const [one, other] = [Float64Array.from([0, 1, 2]), Float64Array.from([0, 1, 2.0000001])];
  expect(stops.show(10, one)).toBeNull();
  expect(stops.show(10, one)).toBeNull();
  expect(stops.show(0, other)).toBeNull();
  expect(stops.show(1, one.slice())).toBe("fair");
  expect(stops.show(0, one.slice())).toBe("fair");
  expect(stops.show(10, other)).toBeNull();
  expect(stops.show(0, Float64Array.from([0]))).toBeNull();
});

it("the shape of a trial holds the points that differ, to the last bit", () => {
  const base = Float64Array.from([0, 0, 0, 1, 1, 1, 2, 2, 2]);
  const now = Float64Array.from([0, 0, 0, 1, 1 + Number.EPSILON, 1, 2, 2, 3]);
  const { moved, positions } = shapeOf(now, base);
  expect([...moved]).toEqual([1, 2]);
  expect([...positions]).toEqual([1, 1 + Number.EPSILON, 1, 2, 2, 3]);
  expect(shapeOf(base, base).moved.length).toBe(0);
});

it("the usual fold is the 95th percentile of panels that have a neighbour", () => {
  const folds = Float32Array.from({ length: 100 }, (_, k) => 100 - k);
  expect(usualFold(folds)).toBe(95);
  expect(usualFold(Float32Array.from([-1, -1, 7]))).toBe(7);
  expect(usualFold(new Float32Array(0))).toBeNull();
});

it("the sharpest fold is of panels that have a neighbour, too", () => {
  expect(sharpestFold(Float32Array.from([3, -1, 79.5, 12]))).toBe(79.5);
  expect(sharpestFold(Float32Array.from([-1, 0]))).toBe(0);
  expect(sharpestFold(Float32Array.from([-1]))).toBeNull();
});
