// SPDX-License-Identifier: MIT
// How far a panel is out of flat, in words: the same ones everywhere.
import { usual } from "virtual:core-defaults";
import { formatGap, type Unit } from "../quantity/units.ts";

/** mm/m: what a finished design promises. What is below is rounding, and no figure worth reading. */
export const FLAT = usual.tolerance;

/** FLAT without a power of ten: "0.000001". */
export const FLAT_TEXT = FLAT.toFixed(Math.round(-Math.log10(FLAT)));

const PROMISE = `< ${FLAT_TEXT}`;

/** What "flat" in a column means. */
export const FLAT_MEANS = `flat: ${PROMISE} mm/m`;

export interface FlatnessWords {
  /** "0.0123 mm" */
  readonly gap: string;
  /** "1.23" mm/m, or "flat": in a column of such figures */
  readonly cell: string;
  /** "0.0123 mm (1.23 mm/m)", "0.0000 mm, flat": where there is little room */
  readonly short: string;
  /**
   * "0.0123 mm out of flat (1.23 mm/m)", "flat (< 0.000001 mm/m)", and far from the origin
   * "as flat as its coordinates can hold (0.000012 mm/m)"
   */
  readonly sentence: string;
}

/** Whether nothing is out of flat but for the rounding of its coordinates. */
export const isFlat = ({ worstExcess }: { readonly worstExcess: number }): boolean =>
  worstExcess <= FLAT;

/** mm/m without a power of ten: three digits, two below a thousandth, never less than one unit. */
export function decimal(mmPerM: number): string {
  if (mmPerM >= 100) return mmPerM.toFixed(0);
  if (mmPerM >= 1e-3) return mmPerM.toPrecision(3);
  return mmPerM.toFixed(1 - Math.floor(Math.log10(mmPerM)));
}

/**
 * @param gap model units
 * @param mmPerM the same over the panel's longest edge
 * @param excess mmPerM, or 0 where rounding accounts for it
 */
export function flatnessWords(
  gap: number,
  mmPerM: number,
  excess: number,
  unit: Unit,
): FlatnessWords {
  const length = formatGap(gap, unit);
  if (mmPerM <= FLAT) {
    const sentence = `flat (${PROMISE} mm/m)`;
    return { gap: length, cell: "flat", short: `${length}, flat`, sentence };
  }
  const perMetre = decimal(mmPerM);
  if (excess <= FLAT) {
    const sentence = `as flat as its coordinates can hold (${perMetre} mm/m)`;
    return { gap: length, cell: perMetre, short: `${length}, flat but for rounding`, sentence };
  }
  const short = `${length} (${perMetre} mm/m)`;
  return {
    gap: length,
    cell: perMetre,
    short,
    sentence: `${length} out of flat (${perMetre} mm/m)`,
  };
}
