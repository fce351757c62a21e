// SPDX-License-Identifier: MIT
// Reports by the names that the command line writes with --report. Lengths are in model units,
// flatness in mm per m.

export interface Violation {
  readonly kind: string;
  readonly unit: string;
  readonly before_max: number;
  readonly after_max: number;
}

export interface BoundReport {
  readonly name: string;
  readonly [figure: string]: unknown;
}

/** What every operation tells; figures that only some of them have may be undefined. */
export interface Report {
  /** "converged", "infeasible_handles", "cancelled", "done", ... */
  readonly status: string;
  readonly mesh: Readonly<Record<string, unknown>>;
  readonly planarity_mm_per_m: Readonly<Record<string, number>>;
  readonly solver?: string;
  readonly objective?: Readonly<Record<string, number>>;
  readonly moved_vertices?: number;
  readonly max_displacement?: number;
  readonly handle_error?: number;
  readonly iterations?: number;
  readonly optimality?: Readonly<Record<string, number>>;
  readonly violations?: readonly Violation[];
  readonly bounds?: readonly BoundReport[];
  readonly supports?: readonly { readonly name: string; readonly distance_max: number }[];
  readonly symmetry?: {
    readonly elements: readonly string[];
    readonly images: number;
    readonly asymmetry_mean_edges: number;
    readonly base_moved_by?: number;
    readonly base_moved_vertices?: number;
  };
  readonly planarised_first?: Readonly<Record<string, number>>;
  /** Panels that came out flat but crossing, turned over, collapsed or concave. */
  readonly spoilt_faces?: Readonly<Record<string, readonly number[]>>;
  /** Largest distance of a point from the surface that was edited, and longest way along it. */
  readonly motion?: { readonly shape_max: number; readonly slide_max: number };
  readonly sharpest_fold?: { readonly before: number; readonly after: number };
  /** Panels and nodes that the shop makes again. */
  readonly remake?: {
    readonly outline: number;
    readonly bevel: number;
    readonly nodes_moved: number;
    readonly nodes_arms: number;
  };
  readonly verified?: boolean;
  readonly deviation?: number;
  readonly [figure: string]: unknown;
}
