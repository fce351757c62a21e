// SPDX-License-Identifier: MIT
// What alike_bindings.cpp lists, by hand.

/** How panels of a mesh become alike; lengths are shares of its mean edge. */
export interface AlikeAsked {
  /** At most so many types, within whatever that takes; 0: within `within`. */
  readonly types: number;
  /** Of a corner from its template's. */
  readonly within: number;
  /** Of any point. */
  readonly move: number;
  /** A panel may be its template turned over. */
  readonly mirrored: boolean;
  readonly keepBoundary: boolean;
  /** mm/m: of the mesh, and of what comes of it. */
  readonly tolerance: number;
  /** As --bound says them; without one on folds these get at most 5° sharper. */
  readonly limits: readonly string[];
}

/** With `problem` not empty, a clause, the rest is absent. */
export interface AlikeMesh {
  readonly problem: string;
  /** Types of panels, both within the same. */
  readonly before: number;
  readonly after: number;
  /** No more types than were asked for. */
  readonly reached: boolean;
  /** How far a corner may be from its template's: model units, and of the new mesh's mean edge. */
  readonly within: number;
  readonly share: number;
  /** Of any point, model units. */
  readonly maxMove: number;
  /** OBJ, every bit of it. */
  readonly file: Uint8Array;
}

export interface AlikeModule {
  /** As the command line's project --move, of an OBJ. `say` gets the number of steps so far. */
  alike(obj: Uint8Array, asked: AlikeAsked, say: (steps: number) => void): AlikeMesh;
}
