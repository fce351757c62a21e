// SPDX-License-Identifier: MIT
// Which points a line drawn on screen goes round.
import type { Outline } from "./outline.ts";
import { type Box, eachOnScreen, type Place, type Points, type View } from "./picking.ts";

/** The smallest box that holds all of it. */
export function boundsOf(outline: Outline): Box {
  const [xs, ys] = [outline.map(({ x }) => x), outline.map(({ y }) => y)];
  return {
    left: Math.min(...xs),
    top: Math.min(...ys),
    right: Math.max(...xs),
    bottom: Math.max(...ys),
  };
}

/**
 * Whether it goes round a place, once or more often: where a loop crosses itself, what it encloses
 * twice is inside, too.
 */
export function encloses(outline: Outline, { x, y }: Place): boolean {
  let turns = 0;
  let a = outline.at(-1);
  for (const b of outline) {
    if (!a) break;
    const side = (b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y);
    if (a.y <= y && b.y > y && side > 0) turns += 1;
    if (a.y > y && b.y <= y && side < 0) turns -= 1;
    a = b;
  }
  return turns !== 0;
}

/** The points that it goes round on screen, ascending. */
export function verticesIn(outline: Outline, { current, isShown }: Points, view: View): number[] {
  const { left, top, right, bottom } = boundsOf(outline);
  const found: number[] = [];
  eachOnScreen(current, view, (v, x, y) => {
    const near = x >= left && x <= right && y >= top && y <= bottom;
    if (near && encloses(outline, { x, y }) && isShown(v)) found.push(v);
  });
  return found;
}
