// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { deviationWords, distance, formatSmall } from "../../web/src/state/deviating.ts";

it("writes small lengths with the digit that counts", () => {
  expect(formatSmall(2.3e-8, "m")).toBe("0.00002 mm");
  expect(formatSmall(9.6e-7, "m")).toBe("0.0010 mm");
  expect(formatSmall(1e-14, "m")).toBe("0.000000001 mm");
  expect(formatSmall(0.005, "m")).toBe("5.0 mm");
});

it("is calm about rounding and plain about more", () => {
  expect(deviationWords(0, 30, "m")).toMatch(/^Verified: /);
  expect(deviationWords(2e-8, 30, "m")).toMatch(/differ by up to 0\.00002 mm: rounding\.$/);
  expect(deviationWords(0.005, 30, "m")).toBe(
    "Replayed: differs from the shared result by up to 5.0 mm at the recorded points.",
  );
});

it("measures between shapes that do not move the same points", () => {
  const base = Float64Array.from([0, 0, 0, 1, 0, 0, 2, 0, 0]);
  const shape = (moved: number[], positions: number[]) => ({
    moved: Int32Array.from(moved),
    positions: Float64Array.from(positions),
  });
  const [a, b] = [shape([0], [0, 0, 3]), shape([0, 2], [0, 0, 3.5, 2, 4, 0])];
  expect(distance(a, b, base)).toBe(4);
  expect(distance(a, a, base)).toBe(0);
  expect(distance(shape([], []), a, base)).toBe(3);
});
