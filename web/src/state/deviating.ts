// SPDX-License-Identifier: MIT
// In words, how far a design that was computed again is from what was recorded of it.

import { convert, formatLength, type Unit } from "../quantity/units.ts";
import type { Shape } from "../solver/protocol.ts";

/** Share of the model's size within which the builds for browsers and for the command line agree
 * (docs/reliability.md): the order of rounding differs. */
const ROUNDING = 1e-9;
/** Millimetres that the page would write as 0.00. */
const INVISIBLE = 0.005;
/** Millimetres: for less this is written, as a bound. */
const SMALLEST = 1e-9;

/** Largest distance between two shapes of one base; all in model units. */
export function distance(a: Shape, b: Shape, base: Float64Array): number {
  const placeOf = (shape: Shape) => {
    const rows = new Map(Array.from(shape.moved, (vertex, k) => [vertex, k]));
    return (vertex: number, axis: number): number => {
      const k = rows.get(vertex);
      return (k === undefined ? base[3 * vertex + axis] : shape.positions[3 * k + axis]) ?? 0;
    };
  };
  const [inA, inB] = [placeOf(a), placeOf(b)];
  const gap = (v: number): number =>
    Math.hypot(...[0, 1, 2].map((axis) => inA(v, axis) - inB(v, axis)));
  return [...a.moved, ...b.moved].reduce((largest, v) => Math.max(largest, gap(v)), 0);
}

/** Whether a deviation is no more than another order of rounding. */
export const isRounding = (off: number, size: number, unit: Unit): boolean =>
  off <= ROUNDING * size || convert(off, unit, "mm") < INVISIBLE;

/** "0.00002 mm": small lengths with the digit that counts, never as a power of ten. */
export function formatSmall(off: number, unit: Unit): string {
  const mm = convert(off, unit, "mm");
  if (mm >= INVISIBLE) return formatLength(off, unit);
  const written = Math.max(mm, SMALLEST);
  return `${written.toFixed(Math.ceil(-Math.log10(written)))} mm`;
}

/**
 * A mark records a few points only.
 * @param off model units; 0 for the same bits
 * @param size of the model, model units
 */
export function deviationWords(off: number, size: number, unit: Unit): string {
  if (off === 0) return "Verified: the same result as when it was shared, to the last bit.";
  const amount = formatSmall(off, unit);
  return isRounding(off, size, unit)
    ? `Replayed: recomputed here, the recorded points differ by up to ${amount}: rounding.`
    : `Replayed: differs from the shared result by up to ${amount} at the recorded points.`;
}
