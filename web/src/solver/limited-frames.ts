// SPDX-License-Identifier: MIT
// Frames of a drag within stated limits. Where a target is far beyond them, a frame may find next to
// nothing on its way there: then the one before it stays.
import type { Shape, ShapeReport } from "./protocol.ts";

export interface Frame {
  readonly report: ShapeReport;
  readonly shape: Shape;
}

/** Share of the largest move before. */
const FELL_BACK = 0.5;

export class LimitedFrames {
  #last: Frame | null = null;

  /** What is to be shown instead of `frame`; null: itself. */
  instead(frame: Frame): Frame | null {
    const last = this.#last;
    const { handleError, maxDisplacement } = frame.report;
    const back =
      last !== null &&
      handleError > last.report.handleError &&
      maxDisplacement < FELL_BACK * last.report.maxDisplacement;
    if (back) return last;
    this.#last = frame;
    return null;
  }
}
