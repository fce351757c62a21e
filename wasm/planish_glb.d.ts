// SPDX-License-Identifier: MIT
// What glb_bindings.cpp lists, by hand.

/** With `problem` not empty, the file was refused and the rest is absent. */
export interface OpenedGlb {
  readonly problem: string;
  /** OBJ: the base if the file holds a design, else the mesh. */
  readonly mesh: Uint8Array;
  /** The recipe as text; "" for none. */
  readonly design: string;
  /** With a design: the stored result, where it differs from the base. */
  readonly moved: Int32Array;
  readonly positions: Float64Array;
  readonly warnings: readonly string[];
}

export interface GlbModule {
  openGlb(bytes: Uint8Array): OpenedGlb;
  /** `mesh`: OBJ of the design shown. `displacements`: 3 × |support| for each variation. */
  assembleGlb(
    mesh: Uint8Array,
    base: Float64Array,
    support: Int32Array,
    displacements: Float64Array,
    design: string,
  ): Uint8Array;
}

export default function createPlanishGlb(options?: object): Promise<GlbModule>;
