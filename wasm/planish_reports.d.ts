// SPDX-License-Identifier: MIT
// What report_values.cpp makes of the reports in session_report.hpp, by hand;
// tests/parity/bindings.test.ts holds the two together. Numbers that are not finite are null.

export interface MeshReport {
  readonly vertices: number;
  readonly faces: number;
  /** Panels of each number of corners. */
  readonly faceSizes: Readonly<Record<string, number>>;
  readonly boundaryLoops: number;
  readonly components: number;
  readonly nonmanifoldEdges: number;
  readonly meanEdge: number;
  readonly degreesOfFreedom: number;
  readonly worstGap: number;
  readonly worstMmPerM: number;
  /** mm/m beyond what rounding accounts for: the mesh is flat where a tolerance allows it. */
  readonly worstExcess: number;
  /** Points that planarising moved, and the longest way, model units; zeros if there was none. */
  readonly planarising: { readonly moved: number; readonly largest: number };
  /** How far the mesh is from each kind that could bind it, by the kind's name. */
  readonly kinds: Readonly<Record<string, KindDefects>>;
  readonly centre: readonly [number, number, number];
  readonly scale: number;
  readonly warnings: readonly string[];
}

/** Degrees. `excess`: beyond rounding. */
export interface KindDefects {
  readonly median: number;
  readonly worst: number;
  readonly excess: number;
}

/** Degrees between neighbouring panels. */
export interface SharpestFold {
  readonly before: number;
  readonly after: number;
  /** By how much the fold that sharpened most did; at least 0. */
  readonly growth: number;
  /** The two that meet so now; -1 where no two do. */
  readonly panels: readonly number[];
}

/** Model units, all at least 0: how far points are off the old surface, and along it, at most. */
export interface MotionRange {
  /** On the outside of the old surface. */
  readonly raised: number;
  readonly lowered: number;
  readonly slide: number;
}

export interface ShapeReport {
  readonly status: string;
  readonly movedVertices: number;
  readonly maxDisplacement: number;
  readonly motion: MotionRange;
  readonly worstGap: number;
  readonly worstMmPerM: number;
  /** mm/m: of the panel for which the rounding of its coordinates accounts least; often 0. */
  readonly worstExcess: number;
  /** Of the panels that the edit touches. */
  readonly sharpestFold: SharpestFold;
  readonly handleError: number;
  readonly objective: number;
  /** Steps in which the targets were approached; 0: at once. */
  readonly continuation: number;
  /** Whether the same edit at once ends lower than along its path. */
  readonly lowerAtOnce: boolean;
  readonly iterations: number;
  readonly seconds: number;
  readonly residuals: readonly number[];
  /** How far from a first-order point; without fields where nothing was certified. */
  readonly optimality: Optimality | NotCertified;
  /** The panels that each stated limit holds back, by its name. */
  readonly bounds: Readonly<Record<string, readonly number[]>>;
  /** Worst defect of each kind that is kept beside flatness, degrees. */
  readonly violations: Readonly<Record<string, { before: number; after: number }>>;
}

/** The core's Optimality. */
export interface Optimality {
  readonly stationarity: number | null;
  readonly outside: number | null;
  readonly complementarity: number;
  readonly certifiedVertices: number;
}

export type NotCertified = Readonly<Record<string, never>>;

export interface VariationsReport {
  readonly status: string;
  readonly dimension: number;
  readonly correlation: readonly number[];
  readonly seconds: number;
}

/** What replaying gave, beside the shape that is shown. */
export interface Replayed {
  /** Found for each variation. */
  readonly directions: Int32Array;
  /** What the last variation was found around; empty without any. */
  readonly moved: Int32Array;
  readonly positions: Float64Array;
  /** From the design's result, model units; 0: the same to the last bit, or nothing to compare. */
  readonly deviation: number;
}
