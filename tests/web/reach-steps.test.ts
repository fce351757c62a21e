// SPDX-License-Identifier: MIT
// How far an edit reaches where nobody chose it: as far as it has to.
import { expect, it } from "vitest";
import { FIRST_SETTINGS } from "../../web/src/design/design.ts";
import { REACHES, ReachSteps } from "../../web/src/solver/reach-steps.ts";

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
