// SPDX-License-Identifier: MIT
// The figures at the ends of the ramps that colour the model, and the places in between.
import { FLAT } from "../design/flatness.ts";
import { MEANT } from "../design/kept-kind.ts";
import { PER_PANEL } from "../solver/protocol.ts";

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

/**
 * At the ends of the ramps of shape and slide: the largest, on whichever side; a share of the largest
 * move at least, below which they are rounding.
 */
export function motionEnd(figures: Iterable<number>, move: number): number {
  const LEAST = 1e-3;
  let end = LEAST * move;
  for (const figure of figures) end = Math.max(end, Math.abs(figure));
  return end;
}

/** Degrees at the end of the ramp of folds, at least: where a crease begins to be seen as one. */
const CREASE = 30;

/** Degrees at the end of the ramp of folds: those of a crease, or the sharpest fold. */
export const foldEnd = (folds: Float32Array): number => largest(folds, CREASE);

/** Degrees at the end of the ramp of conjugacy: lines that are farther off are no better. */
export const CONJUGACY_END = 45;

/** Degrees at the end of the ramp of a kind's defects: the worst, at least what still counts as kept. */
export const defectEnd = (defects: Float32Array): number => largest(defects, MEANT);
