// SPDX-License-Identifier: MIT
// What glb_bindings.cpp lists, by hand.

import type { Defaults, DesignReading, DesignValue } from "./planish_designs.d.ts";

export type * from "./planish_designs.d.ts";

/** With `problem` not empty, the file was refused and the rest is absent. */
export interface OpenedGlb {
  readonly problem: string;
  /** OBJ: the base if the file holds a design, else the mesh. */
  readonly mesh: Uint8Array;
  /** The recipe; null for none. */
  readonly stored: DesignReading | null;
  /** With a design: the stored result, where it differs from the base. */
  readonly moved: Int32Array;
  readonly positions: Float64Array;
  readonly warnings: readonly string[];
}

export interface GlbModule {
  openGlb(bytes: Uint8Array): OpenedGlb;
  /** `mesh`: OBJ of the design shown. `displacements`: 3 × |support| for each variation. `offset`:
   * the points of a second layer, or none. */
  assembleGlb(
    mesh: Uint8Array,
    base: Float64Array,
    support: Int32Array,
    displacements: Float64Array,
    offset: Float64Array,
    design: DesignValue,
  ): Uint8Array;
  /** OBJ, its triangles joined into quads, the points that its panels have of their own, or its panels
   * turned until neighbours agree; empty where that gives no mesh, or without memory. */
  mend(mesh: Uint8Array, way: "joinTriangles" | "joinPoints" | "orient"): Uint8Array;
  /** Of each point (x, y, z) the number of the one whose place it takes, from 0 in the order of those
   * that keep theirs; none without memory. `within`: model units. */
  joinedPoints(points: Float64Array, within: number): Int32Array;
  /** Any text: a design, or one sentence that names the field. */
  readDesign(text: string): DesignReading;
  /** A design's text as docs/formats.md describes it; "" without memory. */
  writeDesign(design: DesignValue): string;
  /** A design's text for a link: a file that is UTF-8 rides along as text, which compresses. */
  writeLinkText(design: DesignValue): string;
  defaults(): Defaults;
}
