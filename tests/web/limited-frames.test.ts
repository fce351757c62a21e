// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { LimitedFrames } from "../../web/src/solver/limited-frames.ts";
import { NO_REPORT, NO_SHAPE } from "../../web/src/state/design.ts";

const frame = (handleError: number, maxDisplacement: number) => ({
  report: { ...NO_REPORT, handleError, maxDisplacement },
  shape: NO_SHAPE,
});

it("a frame that falls back though its target is further away is not shown", () => {
  const frames = new LimitedFrames();
  const reached = frame(0.1, 2);
  expect(frames.instead(frame(0.1, 1))).toBeNull();
  expect(frames.instead(reached)).toBeNull();
  expect(frames.instead(frame(2, 0.1))).toBe(reached);
  expect(frames.instead(frame(3, 0))).toBe(reached);
});

it("a drag that goes back is shown, and so is one that the limits hold where it is", () => {
  const frames = new LimitedFrames();
  expect(frames.instead(frame(0.1, 2))).toBeNull();
  expect(frames.instead(frame(1, 1.9))).toBeNull();
  expect(frames.instead(frame(0, 0.5))).toBeNull();
});
