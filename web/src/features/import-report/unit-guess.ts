// SPDX-License-Identifier: MIT
// Which unit the numbers of a file are likely to be in, by the size of what is built of panels.
import { extentOf } from "../../mesh/extent.ts";
import { convert, type Unit } from "../../quantity/units.ts";

/** Metres: roofs and facades are between these. */
const [SMALLEST, LARGEST] = [2, 500];

const LIKELY: readonly Unit[] = ["m", "mm", "cm"];

/** Along x, y and z, in the numbers of the file. */
export function sizesOf(points: ArrayLike<number>): readonly number[] {
  const { low, high } = extentOf(points);
  return high.map((top, axis) => top - (low[axis] ?? 0));
}

/** null where `unit` is as likely as any. */
export function guessedUnit(sizes: readonly number[], unit: Unit): Unit | null {
  const largest = Math.max(...sizes);
  const fits = (one: Unit): boolean => {
    const metres = convert(largest, one, "m");
    return metres >= SMALLEST && metres <= LARGEST;
  };
  return fits(unit) ? null : (LIKELY.find(fits) ?? null);
}

const rounded = (size: number): number => Number(size.toPrecision(size < 1000 ? 3 : 5));

/** "17,071 × 11,336 × 3,200". */
export const sizeWords = (sizes: readonly number[]): string =>
  sizes.map((size) => rounded(size).toLocaleString("en")).join(" × ");
