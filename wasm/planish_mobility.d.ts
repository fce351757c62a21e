// SPDX-License-Identifier: MIT
// What mobility_bindings.cpp lists, by hand.
import type { MobilityValue as MobilityRow } from "./package/src/planish_package.d.mts";
import type { EditOptions } from "./planish_designs.d.ts";

export type { MobilityRow };

export interface MobilityMap {
  /** Up, down and two directions of the surface. */
  measure(vertex: number): MobilityRow[];
  /** The best places of what has been measured, the best first. */
  best(count: number): MobilityRow[];
  delete(): void;
}

export interface MobilityModule {
  /** `settings`: of the page's edits. */
  openMap(
    positions: Float64Array,
    faceOffsets: Int32Array,
    faceVertices: Int32Array,
    settings: EditOptions,
  ):
    | { readonly map: MobilityMap; readonly problem?: undefined }
    | { readonly problem: string; readonly map?: undefined };
}
