// SPDX-License-Identifier: MIT
// A plane at right angles to an axis that cuts the view open.
import { isNumbers } from "./reading.ts";

/** Cuts the view open; model units. */
export interface SectionPlane {
  readonly axis: 0 | 1 | 2;
  readonly at: number;
  /** Whether what is above it along the axis is shown, instead of what is below. */
  readonly flipped: boolean;
}

export const writeSection = ({ axis, at, flipped }: SectionPlane): [0 | 1 | 2, number, 0 | 1] => [
  axis,
  at,
  flipped ? 1 : 0,
];

/** null where it is none. */
export function readSection(value: unknown): SectionPlane | null {
  if (!isNumbers(value, 3)) return null;
  const [axis, at = 0, side] = value;
  return axis === 0 || axis === 1 || axis === 2 ? { axis, at, flipped: side === 1 } : null;
}
