// SPDX-License-Identifier: MIT
// How far an edit reaches where nobody chose it: as far as it has to.
import { expect, it } from "vitest";
import { FIRST_SETTINGS, NO_REPORT } from "../../web/src/design/design.ts";
import type { ShapeReport } from "../../web/src/solver/protocol.ts";
import { REACHES, ReachSteps, suffices } from "../../web/src/solver/reach-steps.ts";

const WAY = 2;
const report = (more: Partial<ShapeReport> = {}): ShapeReport => ({
  ...NO_REPORT,
  status: "converged",
  movedVertices: 9,
  handleError: 0.04 * WAY,
  sharpestFold: { before: 17, after: 27, growth: 10 },
  ...more,
});

it("suffices where handles arrive, folds stay fair and nothing binds", () => {
  expect(suffices(report(), WAY, 0.05)).toBe(true);
  expect(suffices(report({ handleError: 0.06 * WAY }), WAY, 0.05)).toBe(false);
  const creased = { before: 17, after: 20, growth: 10.1 };
  expect(suffices(report({ sharpestFold: creased }), WAY, 0.05)).toBe(false);
  expect(suffices(report({ status: "infeasible_handles" }), WAY, 0.05)).toBe(false);
  // A frame whose time is over may be near enough; one that found no way to move is not.
  expect(suffices(report({ status: "iteration_limit" }), WAY, 0.05)).toBe(true);
  const stuck = { status: "iteration_limit", movedVertices: 0, handleError: 0 } as const;
  expect(suffices(report(stuck), WAY, 0.05)).toBe(false);
});

it("grows in one drag and stays, and another begins anew", () => {
  const steps = new ReachSteps();
  expect(steps.now).toBeNull();
  expect(steps.begins([5, 0, 0, 0], [2, 3, 6])).toBe(true);
  expect(steps.begins([5, 0, 0, 0], [2, 3, 6])).toBe(false);
  expect(steps.now).toBe(2);
  steps.grow();
  expect(steps.now).toBe(3);
  expect(steps.isLast).toBe(false);
  steps.grow();
  expect([steps.now, steps.isLast]).toEqual([6, true]);
  expect(steps.begins([7, 0, 0, 0], [])).toBe(true);
  expect([steps.now, steps.isLast]).toEqual([null, true]);
});

it("is at most what a new visitor's page starts with", () => {
  expect(REACHES.at(-1)).toBe(FIRST_SETTINGS.reach);
  expect(REACHES).toEqual([...REACHES].sort((a, b) => a - b));
});
