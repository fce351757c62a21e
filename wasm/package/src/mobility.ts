// SPDX-License-Identifier: MIT
// Where a mesh can move: how far each vertex gets before a panel stops it.
import { insist } from "./error.ts";
import type { Mesh } from "./mesh.ts";
import type { MobilityHandle, MobilityValue } from "./planish_package.mjs";
import { Place } from "./pool.ts";
import { type Bounds, type Constraints, type ModelUnit, request } from "./request.ts";

/** One vertex in one direction, which is of length 1; distances are in model units, folds in degrees. */
export type MobilityRow = MobilityValue;

/** Options of `planish mobility`, by the same names; what is left out has the core's default. */
export interface MobilityOptions {
  /** The points to measure; all without. */
  readonly vertices?: Iterable<number>;
  /** Model units: moves are tried up to there. */
  readonly range?: number | string;
  readonly steps?: number;
  readonly bounds?: Bounds | readonly string[];
  readonly constraints?: Constraints;
  readonly locality?: number;
  readonly smoothness?: number;
  /** 1 to 10: in place of locality and smoothness. */
  readonly softness?: number;
  readonly reach?: number | string;
  readonly keepBoundary?: boolean;
  readonly modelUnit?: ModelUnit;
  readonly fairness?: "laplacian" | "second" | "third";
  readonly sparsity?: "l21" | "l2" | "none";
  /** mm per m */
  readonly tolerance?: number;
  /** Called after every few vertices; false stops, and what is there is returned. */
  readonly progress?: (done: number, total: number) => boolean | undefined;
}

/** Vertices between two calls of progress. */
const CHUNK = 16;

/** Four rows for each vertex: up, down, and the two best directions of the surface. */
export class Mobility {
  readonly rows: readonly MobilityRow[];
  readonly #place: Place<MobilityHandle>;

  /** @internal Use mobility(). */
  constructor(rows: readonly MobilityRow[], place: Place<MobilityHandle>) {
    this.rows = rows;
    this.#place = place;
  }

  /** The file that `planish mobility -o` writes; in GLB the mesh has colours. */
  write(format: "json" | "csv" | "glb"): Uint8Array {
    return insist(this.#place.handle().bytes(this.rows, `mobility.${format}`));
  }
}

/** How far each vertex gets before a panel stops it. Takes some 0.1 s a vertex. @throws PlanishError */
export function mobility(mesh: Mesh, options: MobilityOptions = {}): Mobility {
  const { vertices, progress, ...named } = options;
  const { core } = mesh;
  const asked = request({ ...named, threads: 1 }); // that is all there is
  const place = new Place(core.pool, () => insist(core.module.mobility(mesh.handle(), asked)));
  const all = vertices ?? new Array(mesh.points.length / 3).keys();
  const chosen = [...new Set(all)].sort((a, b) => a - b);
  const rows: MobilityRow[] = [];
  for (let k = 0; k < chosen.length; k += CHUNK) {
    rows.push(...insist(place.handle().measure(chosen.slice(k, k + CHUNK))));
    if (progress?.(Math.min(k + CHUNK, chosen.length), chosen.length) === false) break;
  }
  return new Mobility(rows, place);
}
