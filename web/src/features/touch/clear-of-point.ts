// SPDX-License-Identifier: MIT
// Where something of a known size stands in the view for a finger to press, off the point that it is about.
import type { Place } from "../../scene/picking.ts";

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** What is offered after a drag by a finger. */
export const OFFER: Size = { width: 216, height: 68 };

/** Pixels that stay free about the point, for what it raised. */
const CLEAR = 72;
/** Pixels at the top of the view that the tools cover, and at its bottom the colours. */
const [TOOLS, FOOT] = [52, 88];

/** The upper left corner of an offer clear of `point`, whole pixels: at the foot of the view, or its top. */
export function clearOfPoint(point: Place, size: Size, view: Size): Place {
  const low = view.height - FOOT - size.height;
  return {
    x: Math.round(Math.max(0, (view.width - size.width) / 2)),
    y: Math.round(point.y + CLEAR <= low ? low : TOOLS),
  };
}
