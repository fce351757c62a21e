// SPDX-License-Identifier: MIT
import { Color } from "three";
import { PER_PANEL } from "../solver/protocol.ts";
import { FLAT } from "../state/flatness.ts";
import { MEANT } from "../state/kept-kind.ts";

/** Linear-light colour stops, blended in between. */
export type Ramp = readonly Color[];

export const makeRamp = (stops: readonly string[]): Ramp => stops.map((stop) => new Color(stop));

/** Writes the ramp's colour at `t` in 0 … 1 to `out` at `offset`. */
export function writeRamp(ramp: Ramp, t: number, out: Float32Array, offset: number): void {
  const place = Math.min(Math.max(t, 0), 1) * (ramp.length - 1);
  const k = Math.min(Math.floor(place), ramp.length - 2);
  const a = ramp[k];
  const b = ramp[k + 1];
  if (!a || !b) return;
  const mix = place - k;
  out[offset] = a.r + (b.r - a.r) * mix;
  out[offset + 1] = a.g + (b.g - a.g) * mix;
  out[offset + 2] = a.b + (b.b - a.b) * mix;
}

/** mm/m: the limit of the paper's fabricators. */
export const FABRICATION_LIMIT = 10;

/**
 * mm/m at the planarity ramp's end: the fabrication limit, or the power of ten that holds the worst
 * panel. @param figures gap, mm/m, mm/m beyond rounding of every panel
 */
export function planarityEnd(figures: Float32Array): number {
  let worst = 0;
  for (let k = 2; k < figures.length; k += PER_PANEL.figures)
    worst = Math.max(worst, figures[k] ?? 0);
  return worst <= FABRICATION_LIMIT ? FABRICATION_LIMIT : 10 ** Math.ceil(Math.log10(worst));
}

/** Place on the planarity ramp: 0 when flat, 1 at `end`, logarithmic between. */
export function planarityShare(mmPerM: number, end: number): number {
  if (mmPerM <= FLAT) return 0;
  return 0.15 + (0.85 * Math.log10(mmPerM / FLAT)) / Math.log10(end / FLAT);
}

/** The largest of `values`, at least `least`. */
export const largest = (values: Float32Array, least = 0): number =>
  values.reduce((most, value) => Math.max(most, value), least);

/** Degrees at the end of the ramp of folds, at least: where a crease begins to be seen as one. */
const CREASE = 30;

/** Degrees at the end of the ramp of folds: those of a crease, or the sharpest fold. */
export const foldEnd = (folds: Float32Array): number => largest(folds, CREASE);

/** Degrees at the end of the ramp of a kind's defects: the worst, at least what still counts as kept. */
export const defectEnd = (defects: Float32Array): number => largest(defects, MEANT);

/** Place on the ramp by the core's PanelChange: unchanged, cut again at the end, a new bevel between. */
export const remakePlace = (change: number): number => [0, 1, 0.5][change] ?? 0;

/** The same ramp for a legend. */
export const cssGradient = (stops: readonly string[]): string =>
  `linear-gradient(to right in oklab, ${stops.join(", ")})`;
