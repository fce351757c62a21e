// SPDX-License-Identifier: MIT
// What is done to a whole mesh.
import { insist } from "./error.ts";
import { Mesh } from "./mesh.ts";
import { type Bounds, type Constraints, type ModelUnit, request } from "./request.ts";
import { type Progress, Shape } from "./shape.ts";

/** Options of `planish project`, by the same names. */
export interface ProjectOptions {
  /** Stay close to this mesh instead. */
  readonly reference?: Mesh;
  /** 0 stays as close as possible; higher is fairer and farther away. */
  readonly smooth?: number;
  /** Model units, > 0: no vertex moves farther, and the result is as flat as that allows.
   * With `move` how far a corner may be from its template's, also "0.5%" of the mean edge. */
  readonly within?: number | string;
  readonly pins?: readonly number[];
  readonly keepBoundary?: boolean;
  /** Panels keep their shape; they may stay `flat` mm per m out of flat. With `move` also `fold`. */
  readonly bounds?: Bounds | readonly string[];
  readonly constraints?: Constraints;
  /** What points slide on: "level=z:boundary", "outline:boundary", ... */
  readonly supports?: readonly string[];
  /** At most so many panels, or "10%" of them, are split: the fewest that make the mesh flat. */
  readonly split?: number | string;
  /** Of a flat mesh, more panels become alike, and no point moves farther: model units, or "20%" of the
   * mean edge. */
  readonly move?: number | string;
  /** With `move`: the closest fit found with so many types. */
  readonly types?: number;
  /** With `move`: a panel may be its template turned over. */
  readonly mirrored?: boolean;
  readonly modelUnit?: ModelUnit;
  readonly fairness?: "laplacian" | "second" | "third";
  readonly solver?: "newton" | "alm";
  /** mm per m */
  readonly tolerance?: number;
  readonly progress?: Progress;
}

/** Options of `planish offset`. */
export interface OffsetOptions {
  /** Model units, or with a unit, "25mm"; positive is outside. */
  readonly distance: number | string;
  readonly modelUnit?: ModelUnit;
  readonly kind?: "face" | "vertex" | "parallel";
}

/** Options of `planish convert`. */
export interface ConvertOptions {
  /** Panels that have points of their own share them: at one place, or within that many model units. */
  readonly joinPoints?: boolean | number;
  /** Panels are turned until neighbours agree, the outside out or up. */
  readonly orient?: boolean;
  /** Two by two into the quads that a program split. */
  readonly joinTriangles?: boolean;
}

/** A mended mesh, whose `warnings` say how much was. @throws PlanishError */
export function convert(mesh: Mesh, options: ConvertOptions): Mesh {
  const { core } = mesh;
  const asked = request(options);
  return new Mesh(core, () => insist(core.module.convert(mesh.handle(), asked)));
}

/** Makes every panel flat, close by and fair. @throws PlanishError */
export function project(mesh: Mesh, options: ProjectOptions = {}): Shape {
  const { reference, progress, ...named } = options;
  const { core } = mesh;
  const asked = request({ ...named, reference: reference && "reference" });
  return Shape.of(core, () => {
    const other = reference?.handle() ?? null;
    return insist(core.module.project(mesh.handle(), asked, other, progress ?? null));
  });
}

/** A second layer whose edges are parallel to the mesh's own. @throws PlanishError */
export function offset(mesh: Mesh, options: OffsetOptions): Shape {
  const asked = request(options);
  return Shape.of(mesh.core, () => insist(mesh.core.module.offset(mesh.handle(), asked)));
}
