// SPDX-License-Identifier: MIT
// What bindings.cpp lists, by hand; tests/parity/bindings.test.ts holds the two together. Operations
// return "" when done, otherwise one sentence that says why nothing changed.

import type { AnalysisModule } from "./planish_analysis.d.ts";
import type { CutTrial } from "./planish_cuts.d.ts";
import type {
  DesignValue,
  EditOptions,
  EnumValue,
  MeshFormat,
  Planarising,
  ResultMark,
  VariationFamily,
} from "./planish_designs.d.ts";
import type { EditWays } from "./planish_fewest.d.ts";
import type { MobilityModule } from "./planish_mobility.d.ts";
import type { MeshReport, Replayed, ShapeReport, VariationsReport } from "./planish_reports.d.ts";
import type { SymmetryModule } from "./planish_symmetry.d.ts";

export type * from "./planish_analysis.d.ts";
export type * from "./planish_cuts.d.ts";
export type * from "./planish_designs.d.ts";
export type * from "./planish_fewest.d.ts";
export type * from "./planish_mobility.d.ts";
export type * from "./planish_reports.d.ts";
export type * from "./planish_symmetry.d.ts";

export interface Session {
  openSample(name: string, size: number): string;
  openFile(bytes: Uint8Array, format: string): string;
  planarise(how: Planarising): string;
  /** Takes the flat mesh that another session found: its basePositions(). */
  takePlanarised(found: Float64Array): string;
  /** Sets options for all edits from here on. */
  setOptions(options: EditOptions): string;
  /** Sets supports for all edits from here on, one a line as --support says it; "" for none. */
  setSupports(texts: readonly string[]): string;
  /** Cuts made before the edits of this base, one a line as --cut says it; "" for none. Tolerance in mm/m. */
  setCuts(lines: string, tolerance: number): string;
  /** Tries one more cut, which is not made. */
  tryCut(text: string, tolerance: number): CutTrial;
  /** `handles`: vertex, x, y, z for each. */
  edit(
    mode: EnumValue,
    handles: Float64Array,
    pins: Int32Array,
    continuation: number,
    budgetSeconds: number,
  ): string;
  /** Keeps the edit that is shown; after goBack() the next frame of a drag follows it again. */
  keepEdit(): void;
  goBack(): void;
  /** Shows the edit kept again, with its report. */
  showKept(): void;
  restore(
    handles: Float64Array,
    pins: Int32Array,
    moved: Int32Array,
    positions: Float64Array,
    keepVariations: boolean,
  ): string;
  /** Does it again on the base that is open, whose hash must be this one; null: it is not known. */
  replay(design: DesignValue, baseHash: number | null): string;
  replayed(): Replayed;
  /** The hash of the base that is open, before its cuts, as designs name it. */
  baseHash(): number;
  explore(family: VariationFamily): string;
  vary(coefficients: Float64Array): string;
  /** Leaves the design as it is; the result is in the three projected…() below. */
  projectVariation(coefficients: Float64Array): string;
  makeExact(): string;
  /** The callback returns false to cancel. */
  onProgress(callback: (residual: number) => boolean): void;
  write(format: Exclude<MeshFormat, "glb">): Uint8Array;
  /** Named runs of faces, one a line: first face, blank, name. */
  groups(): string;
  /** Sets other groups in their place, for write(). */
  setGroups(lines: string): string;
  variationSupport(): Int32Array;
  variationDisplacements(): Float64Array;
  basePositions(): Float64Array;
  /** The base as it was opened; empty unless it was planarised since. */
  beforePlanarising(): Float64Array;
  faceOffsets(): Int32Array;
  faceVertices(): Int32Array;
  /** For every panel which one of the mesh before the cuts; empty without any. */
  panelParents(): Int32Array;
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

export interface PlanishModule extends SymmetryModule, EditWays, AnalysisModule, MobilityModule {
  Session: new () => Session;
  EditMode: { drag: EnumValue; release: EnumValue; solve: EnumValue };
  /** The mark of a shape, as designs record it. */
  markOf(moved: Int32Array, positions: Float64Array): ResultMark;
}

export default function createPlanish(options?: object): Promise<PlanishModule>;
