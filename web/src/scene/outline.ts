// SPDX-License-Identifier: MIT
// What is drawn around points on screen to select them: a box, or a loop by hand.
import type { Place } from "./picking.ts";

/** A closed line, pixels from the top left of the canvas; its last place is joined to its first. */
export type Outline = readonly Place[];

/** Pixels between the places of a loop. */
const STEP = 4;

/** The box between two opposite corners. */
export const boxAround = (a: Place, b: Place): Outline => [
  { x: a.x, y: a.y },
  { x: b.x, y: a.y },
  { x: b.x, y: b.y },
  { x: a.x, y: b.y },
];

/** The loop goes on to a place, if that is far enough from where it is. */
export function extended(loop: Outline, to: Place): Outline {
  const last = loop.at(-1);
  return last && Math.hypot(to.x - last.x, to.y - last.y) < STEP ? loop : [...loop, to];
}
