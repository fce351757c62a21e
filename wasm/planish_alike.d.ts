// SPDX-License-Identifier: MIT
// What alike_bindings.cpp lists, by hand.

import type { Session } from "./planish.d.ts";

/** How panels of the mesh shown become alike; shares are of its mean edge. */
export interface AlikeAsked {
  /** Of a corner from its template's. */
  readonly within: number;
  /** Of any point. */
  readonly move: number;
  /** A panel may be its template turned over. */
  readonly mirrored: boolean;
  readonly keepBoundary: boolean;
}

/** With `problem` not empty the rest is absent. */
export interface AlikeMesh {
  readonly problem: string;
  /** Types of panels. */
  readonly before: number;
  readonly after: number;
  /** Of any point, model units. */
  readonly maxMove: number;
  /** OBJ, every bit of it. */
  readonly file: Uint8Array;
}

export interface AlikeModule {
  /** As the command line's project --move; the mesh shown stays. */
  alike(session: Session, asked: AlikeAsked): AlikeMesh;
}
