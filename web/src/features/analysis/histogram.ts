// SPDX-License-Identifier: MIT
// How the figures that colour the model are distributed.

import { LEAST_DEFECT } from "../../design/kept-kind.ts";
import { type OpenedMesh, PER_PANEL, type Shape } from "../../solver/protocol.ts";
import { defectEnd, foldEnd, planarityEnd, planarityShare } from "../../state/ramp-ends.ts";

export interface Histogram {
  /** How many lie in each equal part of the ramp; those at rest are not among them. */
  readonly bins: readonly number[];
  /** Untouched points, flat panels, smooth points. */
  readonly rest: number;
  /** The figure at the ramp's end. */
  readonly end: number;
}

const BINS = 16;
/** Degrees: below is rounding, of coordinates of any size. */
const LEAST_FOLD = 1e-4;

/** @param share place on the ramp, 0 for what is at rest */
function count(values: ArrayLike<number>, end: number, share: (x: number) => number): Histogram {
  const bins = new Array<number>(BINS).fill(0);
  let rest = 0;
  for (let k = 0; k < values.length; ++k) {
    const place = share(values[k] ?? 0);
    const bin = Math.min(BINS - 1, Math.floor(place * BINS));
    if (place > 0) bins[bin] = (bins[bin] ?? 0) + 1;
    else rest += 1;
  }
  return { bins, rest, end };
}

function maximum(values: ArrayLike<number>): number {
  let largest = 0;
  for (let k = 0; k < values.length; ++k) largest = Math.max(largest, values[k] ?? 0);
  return largest;
}

function linear(values: ArrayLike<number>): Histogram {
  const end = maximum(values);
  return count(values, end, (x) => (end > 0 ? x / end : 0));
}

/** How far points moved, model units. */
export function ofDisplacement({ positions: base }: OpenedMesh, shape: Shape): Histogram {
  const lengths = new Float64Array(base.length / 3);
  shape.moved.forEach((v, k) => {
    const gap = (c: number): number => (shape.positions[3 * k + c] ?? 0) - (base[3 * v + c] ?? 0);
    lengths[v] = Math.hypot(gap(0), gap(1), gap(2));
  });
  return linear(lengths);
}

/** How far points moved while they move, from how far each is by now; `total` points in all. */
export function ofMoves(lengths: Iterable<number>, total: number): Histogram {
  const moved = linear([...lengths]);
  return { ...moved, rest: total - moved.bins.reduce((sum, n) => sum + n, 0) };
}

/** Off the old surface, from the farthest inside to the farthest outside; `total` points in all. */
export function ofShape(distances: Iterable<number>, end: number, total: number): Histogram {
  const moved = [...distances];
  const share = (x: number): number => Math.max(Number.MIN_VALUE, (x / end + 1) / 2);
  const counts = count(moved, end, share);
  return { ...counts, rest: total - moved.length };
}

/** How sharply the edit bends at points, model units. */
export const ofBending = (bending: Float32Array): Histogram => linear(bending);

/** Degrees at panels, up to the legend's end. */
export function ofFolds(folds: Float32Array): Histogram {
  const end = foldEnd(folds);
  return count(folds, end, (fold) => (fold < LEAST_FOLD ? 0 : fold / end));
}

/** Degrees by which panels or nodes miss a kind, up to the legend's end. */
export function ofDefects(defects: Float32Array): Histogram {
  const end = defectEnd(defects);
  const bound = defects.filter((defect) => defect >= 0);
  return count(bound, end, (defect) => (defect < LEAST_DEFECT ? 0 : defect / end));
}

/** mm/m of panels, on the legend's logarithmic scale. @param figures gap, mm/m, excess for each */
export function ofPlanarity(figures: Float32Array): Histogram {
  const perMetre = figures.filter((_, k) => k % PER_PANEL.figures === 2);
  const end = planarityEnd(figures);
  return count(perMetre, end, (mmPerM) => planarityShare(mmPerM, end));
}
