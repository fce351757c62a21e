// SPDX-License-Identifier: MIT
// The unit of a file is asked for where the size in the one at hand is that of no building.
import { describe, expect, it } from "vitest";
import {
  guessedUnit,
  sizesOf,
  sizeWords,
} from "../../web/src/features/import-report/unit-guess.ts";

describe("the unit of a file", () => {
  it.each([
    ["a roof of 17 m in millimetres, opened as metres", [17_071, 11_336, 3200], "m", "mm"],
    ["a roof of 17 m, opened as millimetres", [17.071, 11.336, 3.2], "mm", "m"],
    ["a roof of 17 m, opened as metres", [17.071, 11.336, 3.2], "m", null],
    ["a roof of 17 m in millimetres, opened as such", [17_071, 11_336, 3200], "mm", null],
    ["a facade of 90 m in centimetres, opened as kilometres", [9000, 40, 2000], "km", "mm"],
    ["a unit square, opened as metres", [1, 1, 0], "m", null],
  ] as const)("of %s", (_, sizes, unit, guess) => {
    expect(guessedUnit(sizes, unit)).toBe(guess);
  });

  it("is asked for with the size in the numbers of the file", () => {
    expect(sizesOf([0, 0, 0, 17_071.4, -336, 3200, 5, 11_000, 1])).toEqual([
      17_071.4, 11_336, 3200,
    ]);
    expect(sizeWords([17_071.4, 11_336, 3.20149])).toBe("17,071 × 11,336 × 3.2");
  });
});
