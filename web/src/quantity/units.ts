// SPDX-License-Identifier: MIT
// Lengths as people write and read them. The model's own unit is what files hold.

export type Unit = "mm" | "cm" | "m" | "km" | "in" | "ft";

/** Metres per unit. */
const METRES: Readonly<Record<Unit, number>> = {
  mm: 0.001,
  cm: 0.01,
  m: 1,
  km: 1000,
  in: 0.0254,
  ft: 0.3048,
};

const WORDS: Readonly<Record<Unit, string>> = {
  mm: "millimetres",
  cm: "centimetres",
  m: "metres",
  km: "kilometres",
  in: "inches",
  ft: "feet",
};

export const UNITS = Object.keys(METRES) as readonly Unit[];

export const unitWord = (unit: Unit): string => WORDS[unit];

export const isUnit = (text: string): text is Unit => Object.hasOwn(METRES, text);

export const convert = (value: number, from: Unit, to: Unit): number =>
  from === to ? value : (value * METRES[from]) / METRES[to];

/** 1, 2 or 5 times a power of ten, not above `rough`. */
export function niceStep(rough: number): number {
  const power = 10 ** Math.floor(Math.log10(rough || 0.01));
  const lead = rough / power;
  return (lead < 2 ? 1 : lead < 5 ? 2 : 5) * power;
}

/** A coordinate for a field: every digit up to four decimals, without zeros at the end. */
export function formatCoordinate(value: number): string {
  const text = value.toFixed(4).replace(/\.?0+$/, "");
  return text === "-0" ? "0" : text;
}

/** A length for reading, in millimetres up to 10 m: "182 mm", "0.4 mm", "12.3 m". */
export function formatLength(value: number, unit: Unit): string {
  const mm = convert(value, unit, "mm");
  const size = Math.abs(mm);
  if (size >= 10000) return `${(mm / 1000).toFixed(1)} m`;
  if (size > 0 && size < 0.005) return "< 0.01 mm";
  if (size >= 10 || size === 0) return `${mm.toFixed(0)} mm`;
  return size >= 1 ? `${mm.toFixed(1)} mm` : `${mm.toFixed(2)} mm`;
}

/** Out-of-flatness: four decimals of a millimetre, or fewer once it is coarse. */
export function formatGap(value: number, unit: Unit): string {
  const mm = convert(value, unit, "mm");
  return `${mm.toFixed(mm >= 100 ? 1 : mm >= 10 ? 2 : 4)} mm`;
}
