// SPDX-License-Identifier: MIT
// How a group moves as a bump: the middle all the way, what lies further out less.
import { add, minus, type Vector } from "./vector.ts";

/**
 * The share of a move, above 0 and up to 1, that each place takes part in. Those nearest to `middle`
 * go all the way; over the outer `share` of the way to the furthest the move falls off smoothly.
 * @param share 0: all move alike; 1: it falls off from the middle on
 * @param spacing of neighbouring points: so far beyond the furthest nothing would move
 */
export function fallOffWeights(
  places: readonly Vector[],
  middle: Vector,
  share: number,
  spacing: number,
): number[] {
  const gaps = places.map((place) => Math.hypot(...minus(place, middle)));
  const near = Math.min(...gaps);
  const span = Math.max(...gaps) - near + spacing;
  return gaps.map((gap) => {
    const past = share > 0 ? ((gap - near) / span - (1 - share)) / share : 0;
    return past > 0 ? 1 - past * past * (3 - 2 * past) : 1;
  });
}

/** The mean of some places. */
export const middleOf = (places: readonly Vector[]): Vector =>
  places.reduce((sum, place) => add(sum, place, 1 / places.length), [0, 0, 0] as Vector);
