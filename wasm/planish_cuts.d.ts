// SPDX-License-Identifier: MIT
// What a session tells of a cut that is tried out, see bindings.cpp, and what splitting_bindings.cpp lists,
// by hand.

import type { Session } from "./planish.d.ts";
import type { Planarising } from "./planish_designs.d.ts";

/** What one more cut would leave. */
export interface CutTrial {
  /** Why it cannot be made; "" where it can. */
  readonly problem: string;
  /** The cut, and under a symmetry its images, as --cut says them, one a line. */
  readonly cuts: string;
  /** x, y, z of both ends of every new side where the design shown has them, display coordinates. */
  readonly lines: Float32Array;
}

/** What so many lines through panels give, and what they cost. */
export interface SplitStanding {
  /** Each with its images under a symmetry. */
  readonly lines: number;
  /** As --cut says them, behind those that the mesh has. */
  readonly cuts: readonly string[];
  /** Model units. */
  readonly handleError: number;
  readonly movedVertices: number;
  /** With a moved corner, or parts of one that was cut. */
  readonly remadePanels: number;
  /** Degrees, of panels with a moved corner. */
  readonly sharpestFold: number;
}

export interface SplitFinding {
  /** From none on; only what comes nearer than fewer lines do. */
  readonly curve: readonly SplitStanding[];
  /** Edits that were solved for it. */
  readonly tried: number;
  /** Whether the handles arrive with the last of the curve. */
  readonly reached: boolean;
}

export interface SplitModule {
  /** What `most` lines at most let the handles do, by the options and supports that were set; the design
   * shown stays. @param found told none, then the best so far of each number of lines as soon as it is found */
  splitWhereNeeded(
    session: Session,
    handles: Float64Array,
    pins: Int32Array,
    most: number,
    found: (standing: SplitStanding) => void,
  ): (SplitFinding & { readonly problem: "" }) | { readonly problem: string };
  /** As planarise(), with so many panels parted at most; the base is then the parted mesh. */
  splitUntilFlat(session: Session, how: Planarising, most: number): string;
  /** How many the last one parted. */
  splitPanels(session: Session): number;
}
