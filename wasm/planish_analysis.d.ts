// SPDX-License-Identifier: MIT
// What analysis_bindings.cpp lists, by hand.
import type { EnumValue } from "./planish.d.ts";

/** What the points that move can still do, to first order, everything else staying. */
export interface FreedomReport {
  readonly points: number;
  readonly equations: number;
  /** Numerical rank of the flatness equations at these points. */
  readonly rank: number;
  /** 3 · points − rank. */
  readonly freedom: number;
  /** Share of the pull to the targets that the panels bear, 0 … 1. */
  readonly borne: number;
  /** Panels that hold the handles back, most first. */
  readonly holding: readonly number[];
}

/** Nodes to make again: they moved, or only their axis or an arm turned. */
export interface NodeCounts {
  readonly moved: number;
  readonly arms: number;
}

/** One base mesh and the design shown on it. */
export interface Analysis {
  show(moved: Int32Array, positions: Float64Array): void;
  /** Gap (model units) and mm/m of every panel. */
  panelFigures(): Float32Array;
  /** The health of every panel: outline, shortest edge, smallest angle (degrees), a PanelChange. */
  panelHealth(): Float32Array;
  nodesToRemake(): NodeCounts;
  /** A PanelDamage for every panel: what became of it since the mesh was opened; 5 where it is none
   * of them but became a sliver. */
  panelDamage(): Uint8Array;
  /** The sharpest fold of every panel with a neighbour, degrees. */
  panelFolds(): Float32Array;
  /** How far every panel (circular) or vertex (conical) is from the kind, degrees; -1: free. */
  defects(kind: string): Float32Array;
  /** How sharply the edit bends at every vertex, model units. */
  vertexBending(kind: EnumValue): Float32Array;
  /**
   * A family of variations around the edit that `moved` and `positions` give; `moves`: 3 × |support|
   * numbers for each slider, what it does at value 1.
   */
  setFamily(
    moved: Int32Array,
    positions: Float64Array,
    support: Int32Array,
    moves: Float64Array,
  ): void;
  /** The stops of each slider: lower stop, its panel, upper stop, its panel; ±∞ and -1 for none. */
  sliderStops(values: Float64Array): Float64Array;
  /** null where too many points move. `handles`: vertex, x, y, z for each. */
  freedom(handles: Float64Array, pins: Int32Array): FreedomReport | null;
  delete(): void;
}

export interface AnalysisModule {
  /** `opened`: the positions before planarising, empty if there was none. */
  Analysis: new (
    positions: Float64Array,
    offsets: Int32Array,
    vertices: Int32Array,
    opened: Float64Array,
  ) => Analysis;
  FairnessKind: { laplacian: EnumValue; second: EnumValue; third: EnumValue };
}
