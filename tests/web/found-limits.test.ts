// SPDX-License-Identifier: MIT
// How an edit's folds are told, and which limits are of those that it gets of itself.
import { fairFolds } from "virtual:core-defaults";
import { expect, it } from "vitest";
import { NO_REPORT } from "../../web/src/design/design.ts";
import { foldGrowth, isFound, stepOf } from "../../web/src/solver/found-limits.ts";

it("sees a crease in a smooth place, however sharp the folds elsewhere are", () => {
  const crease = { ...NO_REPORT, sharpestFold: { before: 17, after: 17, growth: 15 } };
  expect(foldGrowth(crease)).toBe(15);
  const old = { ...NO_REPORT, sharpestFold: { before: 3, after: 9 } };
  expect(foldGrowth(old)).toBe(6);
});

it("is a multiple of ten degrees, so that one that somebody states otherwise is none that was found", () => {
  expect([0, 9.9, 10, 10.005, 10.1, 27].map(stepOf)).toEqual([10, 10, 10, 10, 20, 30]);
  expect(isFound("fold=+20", [])).toBe(true);
  expect(isFound("angle=20:170", [])).toBe(true);
  expect(isFound("angle=20:170", ["angle=20:170"])).toBe(false);
  expect(isFound("fold=+20", ["fold=+20"])).toBe(false);
  for (const degrees of fairFolds) expect(isFound(`fold=+${degrees}`, [])).toBe(true);
  for (const limit of ["fold=20", "fold=+15", "angle=20:160", "area=10"])
    expect(isFound(limit, [])).toBe(false);
});
