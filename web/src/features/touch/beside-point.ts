// SPDX-License-Identifier: MIT
// Where something of a known size lies near a point of the view, for a finger to press.
import type { Place } from "../../scene/picking.ts";

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** What is offered after a drag by a finger. */
export const OFFER: Size = { width: 196, height: 44 };

/** Pixels between it and the point, whose mark it leaves free; above the point also an arrow. */
const [BELOW, ABOVE] = [28, 96];
/** Pixels to the sides of the view. */
const EDGE = 8;
/** Pixels at the top of the view that the tools cover, and at its bottom. */
const [TOOLS, FOOT] = [52, 60];

const within = (x: number, low: number, high: number): number => Math.max(low, Math.min(x, high));

/** Its upper left corner, whole pixels: below the point, or above where that would be too low. */
export function besidePoint(point: Place, size: Size, view: Size): Place {
  const low = view.height - FOOT - size.height;
  const below = point.y + BELOW;
  const y = below <= low ? below : point.y - ABOVE - size.height;
  return {
    x: Math.round(within(point.x - size.width / 2, EDGE, view.width - EDGE - size.width)),
    y: Math.round(within(y, TOOLS, Math.max(TOOLS, low))),
  };
}
