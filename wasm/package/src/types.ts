// SPDX-License-Identifier: MIT
// Which panels, nodes and bars are alike.
import { insist, wording } from "./error.ts";
import type { Mesh } from "./mesh.ts";
import type { TypesHandle } from "./planish_package.mjs";
import { Place } from "./pool.ts";
import { type ModelUnit, request } from "./request.ts";

/** Options of `planish types`, by the same names; lengths are in `unit`, mm without. */
export interface TypesOptions {
  /** The widths between which joints may vary when one template a type is cut. */
  readonly joint?: readonly [least: number, most: number];
  /** How far a corner may be from its template's, or a share of the mean edge as "0.5%". */
  readonly within?: number | string;
  /** A panel may be its template turned over. */
  readonly mirrored?: boolean;
  /** Degrees, of nodes and bars. */
  readonly angle?: number;
  readonly unit?: ModelUnit;
  /** Of the coordinates; m without. */
  readonly modelUnit?: ModelUnit;
  /** mm per m, up to which a panel is flat. */
  readonly tolerance?: number;
}

/** The JSON report of `planish types`, see docs/types.md. */
export interface TypesReport {
  readonly unit: string;
  readonly types: {
    readonly panels: number;
    readonly types: number;
    readonly within: number;
    readonly mirrored: boolean;
    readonly worst_fit: number;
    readonly sizes: readonly number[];
    readonly joint: { readonly min: number; readonly max: number } | null;
  };
  readonly templates: readonly {
    readonly type: string;
    readonly count: number;
    readonly worst_fit: number;
    readonly outline: readonly number[];
    readonly panels: readonly number[];
  }[];
  readonly [figure: string]: unknown;
}

export class Types {
  readonly report: TypesReport;
  /** What the command line would say, one sentence each; empty if all is well. */
  readonly messages: readonly string[];
  readonly #place: Place<TypesHandle>;

  /** @internal Use types(). */
  constructor(place: Place<TypesHandle>) {
    const handle = place.handle();
    this.report = JSON.parse(handle.report()) as TypesReport;
    this.messages = handle.messages().map(wording);
    this.#place = place;
  }

  /** The table that `planish types -o` writes: which panel is of which type, and how it lies on it. */
  write(format: "csv"): Uint8Array {
    return insist(this.#place.handle().bytes(`types.${format}`));
  }
}

/** What of a mesh is alike; no point moves. @throws PlanishError */
export function types(mesh: Mesh, options: TypesOptions = {}): Types {
  const { core } = mesh;
  const asked = request(options);
  return new Types(new Place(core.pool, () => insist(core.module.types(mesh.handle(), asked))));
}
