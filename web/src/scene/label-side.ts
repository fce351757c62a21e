// SPDX-License-Identifier: MIT
// On which side of a point its figure is written, so that it covers no other mark.

import type { Place } from "./picking.ts";

export type Side = "left" | "right" | "below" | "above";

/** Pixels of a figure, a long one, and between it and its point. */
const WIDE = 180;
const HIGH = 26;
const ASIDE = 20;
/** From its point to its upper edge where it is beside it, and to its nearer edge where not. */
const LIFT = 2;
const DOWN = 18;
/** Half of a mark, with its rim. */
const MARK = 10;

interface Room {
  readonly left: number;
  readonly top: number;
}

/** Upper left corner of a figure on each side; left of a point is free of the arrows and of most of the patch. */
const CORNERS: readonly (readonly [Side, Room])[] = [
  ["left", { left: -ASIDE - WIDE, top: -LIFT }],
  ["right", { left: ASIDE, top: -LIFT }],
  ["below", { left: -WIDE / 2, top: DOWN }],
  ["above", { left: -WIDE / 2, top: -DOWN - HIGH }],
];

/** The first side within the view that covers no mark; else the first within the view, or below. */
export function sideOf(
  at: Place,
  marks: readonly Place[],
  view: { readonly width: number; readonly height: number },
): Side {
  const inside = CORNERS.filter(([, { left, top }]) => {
    const [x, y] = [at.x + left, at.y + top];
    return x >= 0 && x + WIDE <= view.width && y >= 0 && y + HIGH <= view.height;
  });
  const free = inside.find(([, { left, top }]) => {
    const covers = ({ x, y }: Place): boolean => {
      const [right, down] = [x - at.x - left, y - at.y - top];
      return right > -MARK && right < WIDE + MARK && down > -MARK && down < HIGH + MARK;
    };
    return !marks.some(covers);
  });
  return (free ?? inside[0])?.[0] ?? "below";
}
