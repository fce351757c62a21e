// SPDX-License-Identifier: MIT
// The stops of sliders, and what a slider does, as it is shown.

import type { Point } from "../../design/design.ts";
import { counted } from "../../quantity/counted.ts";
import type { SliderLead, SliderRange } from "../../solver/protocol.ts";

/** How far towards its stop a slider may go. */
const CLEAR = 0.9;

/** `x` within the stops that the sliders have in the edit itself. */
export const within = (x: readonly number[], ranges: readonly SliderRange[]): number[] =>
  x.map((value, k) => {
    const { lower, upper } = ranges[k] ?? { lower: -1, upper: 1 };
    return Math.min(Math.max(value, CLEAR * lower), CLEAR * upper);
  });

/** Whether each slider stands between its stops. */
export const isInside = (x: readonly number[], ranges: readonly SliderRange[]): boolean =>
  ranges.every(({ lower, upper }, k) => lower <= (x[k] ?? 0) && (x[k] ?? 0) <= upper);

/** Cosines to the normal: above the first a move goes out of the surface, below the second along it. */
const [OUT, ALONG] = [0.6, 0.4];

/** Which way a move goes on a surface with this normal. */
export function wayWords(move: Point, normal: Point): string {
  const length = Math.hypot(...move) || 1;
  const out = move.reduce((sum, x, axis) => sum + x * (normal[axis] ?? 0), 0) / length;
  if (Math.abs(out) < ALONG) return "along the surface";
  const side = out > 0 ? "out of the surface" : "into the surface";
  return Math.abs(out) > OUT ? side : `${side} and along it`;
}

/** The stops within what a slider can show. */
export const stopsWithin = (
  { lower, upper }: SliderRange,
  end: number,
): readonly [number | null, number | null] => [
  lower > -end ? lower : null,
  upper < end ? upper : null,
];

/** "out of the surface; 42 points". */
export const leadWords = ({ points }: SliderLead, way: string): string =>
  `${way}; ${counted(points, "point")}`;
