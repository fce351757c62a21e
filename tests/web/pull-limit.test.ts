// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { NO_REPORT } from "../../web/src/design/design.ts";
import { keepsOwn, longestWay, ownBound } from "../../web/src/solver/pull-limit.ts";

const FROM = [7, 0, 0, 1];

it("keeps the drag's own limit where no fold sharpens by more", () => {
  const limit = { degrees: 10, short: 0, from: FROM, base: FROM };
  const fold = (after: number) => ({ ...NO_REPORT, sharpestFold: { before: 5, after } });
  expect(keepsOwn(limit, fold(15))).toBe(true);
  expect(keepsOwn(limit, fold(15.1))).toBe(false);
  expect(ownBound(limit)).toBe("fold=+10");
  expect(ownBound({ ...limit, degrees: Number.POSITIVE_INFINITY })).toBeNull();
});

it("a pull is as long as the way of the handle that goes furthest", () => {
  const to = [7, 0, 0, 2, 9, 3, 4, 5];
  expect(longestWay([...FROM, 9, 0, 0, 5], to)).toBe(5);
});
