// SPDX-License-Identifier: MIT
// What bindings.cpp lists, by hand; tests/parity/bindings.test.ts holds the two together. Operations
// return "" when done, otherwise one sentence that says why nothing changed.

import type { MeshReport, ShapeReport, VariationsReport } from "./planish_reports.d.ts";

export type * from "./planish_reports.d.ts";

/** Opaque enumerator. */
export interface EnumValue {
  readonly value: number;
}

export interface HandleEditOptions {
  attraction: number;
  locality: number;
  smoothness: number;
  fairness: EnumValue;
  sparsity: EnumValue;
  hardHandles: boolean;
  keepShape: boolean;
  engine: EnumValue;
  tolerance: number;
  maxIterations: number;
  reach: number;
  reachLength: number;
  keepBoundary: boolean;
  softness: number;
}

export interface SubspaceOptions {
  dimension: number;
  fairnessWeight: number;
  sparsityWeight: number;
  closenessWeight: number;
  correlation: number;
  reach: number;
  eigenbasis: boolean;
  fairness: EnumValue;
  engine: EnumValue;
}

export interface Session {
  openSample(name: string, size: number): string;
  openFile(bytes: Uint8Array, format: string): string;
  /** `constraints`: what it becomes beside flat, one kind a line; "" for none. */
  planarise(smooth: number, keepBoundary: boolean, keepShape: boolean, constraints: string): string;
  setOptions(options: HandleEditOptions): string;
  /** For all edits from here on, one limit a line as --bound says it; "" for none. */
  setLimits(lines: string): string;
  /** For all edits from here on, one kind a line as --constraint says it; "" for none. */
  setConstraints(lines: string): string;
  /** For all edits from here on, one support a line as --support says it; "" for none. */
  setSupports(lines: string): string;
  /** `handles`: vertex, x, y, z for each. */
  edit(
    mode: EnumValue,
    handles: Float64Array,
    pins: Int32Array,
    continuation: number,
    budgetSeconds: number,
  ): string;
  /** Marks where a drag stands; after goBack() its next frame follows that one again. */
  keepFrame(): void;
  goBack(): void;
  restore(
    handles: Float64Array,
    pins: Int32Array,
    moved: Int32Array,
    positions: Float64Array,
    keepVariations: boolean,
  ): string;
  explore(options: SubspaceOptions): string;
  vary(coefficients: Float64Array): string;
  /** Leaves the design as it is; the result is in the three projected…() below. */
  projectVariation(coefficients: Float64Array): string;
  makeExact(): string;
  /** The callback returns false to cancel. */
  onProgress(callback: (residual: number) => boolean): void;
  write(format: "obj" | "off" | "ply"): Uint8Array;
  variationSupport(): Int32Array;
  variationDisplacements(): Float64Array;
  basePositions(): Float64Array;
  /** The base as it was opened; empty unless it was planarised since. */
  beforePlanarising(): Float64Array;
  faceOffsets(): Int32Array;
  faceVertices(): Int32Array;
  displayBase(): Float32Array;
  takeChanges(): Float32Array;
  moved(): Int32Array;
  movedPositions(): Float64Array;
  projectedMoved(): Int32Array;
  projectedPositions(): Float64Array;
  projectedReport(): ShapeReport;
  meshReport(): MeshReport;
  shapeReport(): ShapeReport;
  variationsReport(): VariationsReport;
  delete(): void;
}

export interface PlanishModule {
  Session: new () => Session;
  EditMode: { drag: EnumValue; release: EnumValue; solve: EnumValue };
  Engine: { newton: EnumValue; alm: EnumValue };
  FairnessKind: { laplacian: EnumValue; second: EnumValue; third: EnumValue };
  Sparsity: { l21: EnumValue; l2: EnumValue; none: EnumValue };
}

export default function createPlanish(options?: object): Promise<PlanishModule>;
