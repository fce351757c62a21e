// SPDX-License-Identifier: MIT
// What symmetry_bindings.cpp lists, by hand.

import type { Session } from "./planish.d.ts";

/** What of a mesh is an image of what. */
export interface MeshSymmetry {
  /** As --symmetry says it, one each. */
  readonly elements: readonly string[];
  /** Of every vertex the least of those that it is an image of, itself included. */
  readonly orbits: Int32Array;
}

export interface SymmetryModule {
  /** Edits of the mesh that is open have images from here on; its base is evened out to this
   * tolerance, mm/m. */
  setSymmetry(session: Session, text: string, tolerance: number): string;
  /** null without one. */
  symmetryOf(session: Session): MeshSymmetry | null;
  /** `handles` with their targets on the mirror planes and axes that they are on. */
  onFixedPoints(session: Session, handles: Float64Array): Float64Array;
}
