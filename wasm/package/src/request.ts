// SPDX-License-Identifier: MIT
// Options as the core reads them: a JSON object, by the core's names. Every option is known to the
// core alone, with its default, its range and its errors; what is undefined is not asked for.

/** Limits of the edit, in degrees and model units; lengths may have their unit, "50mm". */
export interface Bounds {
  /** Keep every panel's shape; on unless it is false. */
  readonly shape?: boolean;
  /** Most degrees between neighbours; "+5": at most that much sharper than before. */
  readonly fold?: number | string;
  readonly angle?: readonly [least: number, most: number];
  readonly edge?: readonly [least: number | string, most: number | string];
  readonly area?: number | string;
  readonly sheet?: readonly [width: number | string, height: number | string];
  /** How far any point may go across the mean normal of the panels around it. */
  readonly slide?: number | string;
  /** Panels bent by up to so much, mm/m, stay as bent as they are: none bends more. */
  readonly flat?: number;
}

/** One point and where it goes: by a displacement or to a place. */
export type HandleTarget = { readonly vertex: number } & (
  | { readonly by: readonly [x: number, y: number, z: number] }
  | { readonly to: readonly [x: number, y: number, z: number] }
);

/** "circular", "conical", or each with its tolerance in degrees. */
export type Constraints =
  | readonly string[]
  | { readonly circular?: number; readonly conical?: number };

/** Of the coordinates. */
export type ModelUnit = "mm" | "cm" | "m" | "km" | "in" | "ft";

/** "keepBoundary" → "keep-boundary" */
const coreName = (name: string): string =>
  name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);

/** What JSON has not: arrays of bytes become lists; infinity a text, for the core to refuse. */
function plain(_: string, value: unknown): unknown {
  if (typeof value === "number" && !Number.isFinite(value)) return String(value);
  return ArrayBuffer.isView(value) ? Array.from(value as Float64Array) : value;
}

export function request(options: object): string {
  const named = Object.entries(options).map(([name, value]) => [coreName(name), value]);
  return JSON.stringify(Object.fromEntries(named), plain);
}
