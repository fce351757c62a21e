// SPDX-License-Identifier: MIT
// Which limits an edit gets of itself: those that cost its handles nothing.
import { expect, it } from "vitest";
import { NO_REPORT } from "../../web/src/design/design.ts";
import {
  cornerLimit,
  foldGrowth,
  foldLimit,
  isFound,
  stepOf,
} from "../../web/src/solver/found-limits.ts";
import type { ShapeReport } from "../../web/src/solver/protocol.ts";

const WAY = 2;
const report = (growth: number, short: number, more: Partial<ShapeReport> = {}): ShapeReport => ({
  ...NO_REPORT,
  movedVertices: 9,
  handleError: short * WAY,
  sharpestFold: { before: 17, after: Math.max(17, growth), growth },
  ...more,
});

/** What is found, and the limits that were tried. */
function found(free: ShapeReport, answers: Record<string, ShapeReport>) {
  const tried: string[] = [];
  const limit = foldLimit(free, WAY, (one) => {
    tried.push(one);
    return answers[one] ?? free;
  });
  return { limit, tried };
}

it("is none where no fold sharpens by more than ten degrees, and nothing is tried", () => {
  expect(found(report(10, 0.01), {})).toEqual({ limit: null, tried: [] });
});

it("is the first with which the handles lose no more than a twentieth of their way", () => {
  const answers = { "fold=+10": report(10, 0.2), "fold=+20": report(20, 0.05) };
  expect(found(report(60, 0.01), answers).limit).toBe("fold=+20");
  const near = { "fold=+10": report(10, 0.059) };
  expect(found(report(60, 0.01), near)).toEqual({ limit: "fold=+10", tried: ["fold=+10"] });
});

it("is none where each costs the handles more, or none would bind", () => {
  const far = { "fold=+10": report(10, 0.3), "fold=+20": report(20, 0.3) };
  expect(found(report(60, 0.01), far)).toEqual({ limit: null, tried: ["fold=+10", "fold=+20"] });
  expect(found(report(14, 0.01), far)).toEqual({ limit: null, tried: ["fold=+10"] });
});

it("takes no edit that gave up, though it is as near", () => {
  const gaveUp = report(10, 0.01, { status: "infeasible_handles" });
  expect(found(report(14, 0.01), { "fold=+10": gaveUp }).limit).toBeNull();
});

it("sees a crease in a smooth place, however sharp the folds elsewhere are", () => {
  expect(foldGrowth(report(15, 0))).toBe(15);
  const old = { ...NO_REPORT, sharpestFold: { before: 3, after: 9 } };
  expect(foldGrowth(old)).toBe(6);
});

it("is a multiple of ten degrees, so that one that somebody states otherwise is none that was found", () => {
  expect([0, 9.9, 10, 10.005, 10.1, 27].map(stepOf)).toEqual([10, 10, 10, 10, 20, 30]);
  expect(isFound("fold=+20", [])).toBe(true);
  expect(isFound("angle=20:170", [])).toBe(true);
  expect(isFound("angle=20:170", ["angle=20:170"])).toBe(false);
  expect(isFound("fold=+20", ["fold=+20"])).toBe(false);
  for (const limit of ["fold=20", "fold=+15", "angle=20:160", "area=10"])
    expect(isFound(limit, [])).toBe(false);
});

it("on corners is none where no panel became a sliver, and nothing is tried", () => {
  const none = { report: report(10, 0), slivers: 0 };
  expect(cornerLimit(none, WAY, () => expect.fail("tried"))).toBeNull();
});

it("on corners is the one that panels can be built with, where handles and folds stay as they are", () => {
  const free = { report: report(10, 0.01), slivers: 3 };
  const within = (limited: ShapeReport, slivers = 0) =>
    cornerLimit(free, WAY, () => ({ report: limited, slivers }));
  expect(within(report(10, 0.059))).toBe("angle=20:170");
  expect(within(report(10, 0.07))).toBeNull();
  expect(within(report(11, 0))).toBeNull();
  expect(within(report(10, 0), 1)).toBeNull();
  expect(within(report(10, 0, { status: "infeasible_handles" }))).toBeNull();
  const sharp = { report: report(26, 0.01), slivers: 1 };
  expect(cornerLimit(sharp, WAY, () => ({ report: report(26, 0.01), slivers: 0 }))).toBe(
    "angle=20:170",
  );
});
