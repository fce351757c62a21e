// SPDX-License-Identifier: MIT
// Edits and the variations around them.
import type { Core } from "./core.ts";
import { Design } from "./design.ts";
import type { EditValues } from "./edit-values.ts";
import { insist } from "./error.ts";
import type { Mesh } from "./mesh.ts";
import type { EditHandle, FamilyHandle, VariationHandle } from "./planish_package.mjs";
import { once, Place } from "./pool.ts";
import {
  type Bounds,
  type Constraints,
  type HandleTarget,
  type ModelUnit,
  request,
} from "./request.ts";
import { type Progress, Shape } from "./shape.ts";

/** Options of `planish edit`, by the same names; what is left out has the core's default. */
export interface EditOptions extends Partial<EditValues> {
  readonly handles: readonly HandleTarget[];
  /** Cuts made before the edit, in this order: "strip=12-13@0.4", "corner=40:57"; handles may name their points. */
  readonly cuts?: readonly string[];
  /** Few to make again: points are held as long as the handles arrive; they are pins of the design.
   * A number: until at most so many panels are made again. */
  readonly fewest?: "panels" | "points" | number;
  /** Where handles stop short at most so many panels are parted, as few as let them arrive; `cuts` of the design. */
  readonly splitWhereNeeded?: number;
  /** Of the longest way of a handle, within which handles have arrived for these two: "5%". */
  readonly withinHandle?: string;
  /** Limits how much folds sharpen and the corners of slivers, where that costs the handles nothing and
   * `bounds` has no such limit; `bounds` of the design. */
  readonly fair?: boolean;
  /** Counts types of panels before and after, for the report: alike within a length in units of the mesh,
   * or a share of the mean edge, "0.5%". */
  readonly countTypes?: number | string;
  /** For `countTypes`: a panel may be its template turned over. */
  readonly mirrored?: boolean;
  /** Points that stay. */
  readonly pins?: readonly number[];
  /** What points slide on: "level=z:boundary", "outline:boundary", ... */
  readonly supports?: readonly string[];
  /** Steps in which the handles go to their targets, each solved from the last. */
  readonly continuation?: number;
  /** An edit of one point edits its images: "x", "axis:4", "x,y" or "auto". */
  readonly symmetry?: string;
  readonly hard?: boolean;
  readonly bounds?: Bounds | readonly string[];
  /** Kept from every one of `keepOuts`, model units or with a unit, "50mm". */
  readonly clearance?: number | string;
  readonly constraints?: Constraints;
  /** Face rings, or a length with its unit such as "1.5m". */
  readonly reach?: number | string;
  readonly modelUnit?: ModelUnit;
  readonly solver?: "newton" | "alm";
  readonly progress?: Progress;
}

/** Options of `planish explore` beside those of the edit. */
export interface ExploreOptions {
  readonly dimension: number;
  /** From smooth to stiff. */
  readonly eigen?: boolean;
  /** With `eigen`: the smoothest of a family of so many. */
  readonly family?: number;
  readonly fairWeight?: number;
  readonly sparseWeight?: number;
  readonly closeWeight?: number;
  /** Points that `closeWeight` keeps still; the handles without. */
  readonly close?: readonly number[];
  readonly correlation?: number;
  /** Face rings around the edit that variations may move. */
  readonly spread?: number;
  /** Of `exact()`: higher is fairer and moves more. */
  readonly smooth?: number;
  readonly progress?: Progress;
}

/** Something with a handle that can be made again. */
abstract class Designed<H extends EditHandle> extends Shape {
  readonly #handle: () => H;
  readonly #core: Core;

  protected constructor(core: Core, handle: () => H) {
    super(
      core,
      (use) => once(insist(handle().shape()), use),
      (name) => handle().bytes(name),
    );
    this.#core = core;
    this.#handle = handle;
  }

  /** Base, recipe and mark of the result. */
  get design(): Design {
    const text = new TextDecoder().decode(insist(this.handle().bytes("design.json")));
    return new Design(this.#core, text);
  }

  /** @internal */
  handle(): H {
    return this.#handle();
  }
}

/** A finished edit. */
export class Edit extends Designed<EditHandle> {
  readonly #core: Core;

  /** @internal Use edit(). */
  constructor(core: Core, mesh: Mesh, { progress, ...options }: EditOptions) {
    const asked = request(options);
    const solve = (): EditHandle =>
      insist(core.module.edit(mesh.handle(), asked, progress ?? null));
    const place = new Place(core.pool, solve);
    super(core, place.handle);
    place.keepIfStopped(this.report.status);
    this.#core = core;
  }

  /** A family of local variations around this edit. @throws PlanishError */
  explore({ progress, ...options }: ExploreOptions): Family {
    const core = this.#core;
    const asked = request(options);
    return new Family(core, () =>
      insist(core.module.explore(this.handle(), asked, progress ?? null)),
    );
  }
}

/** Moves a few points; panels stay flat, the rest stays put. @throws PlanishError */
export const edit = (mesh: Mesh, options: EditOptions): Edit => new Edit(mesh.core, mesh, options);

/** The variations of an edit. */
export class Family {
  /** How many independent variations were found: at most what was asked for. */
  readonly dimension: number;
  readonly #core: Core;
  readonly #place: Place<FamilyHandle>;

  /** @internal Use Edit.explore(). */
  constructor(core: Core, make: () => FamilyHandle) {
    this.#core = core;
    this.#place = new Place(core.pool, make);
    this.dimension = this.#place.handle().dimension();
  }

  /**
   * One variation, as the sliders show it.
   * @param coefficients as many as were asked for; 1 moves some point by the edit's largest move
   */
  at(coefficients: ArrayLike<number>): Variation {
    const core = this.#core;
    const asked = request({ coefficients: Array.from(coefficients) });
    return new Variation(core, () => insist(core.module.variation(this.#place.handle(), asked)));
  }
}

/** One member of a family, as the sliders show it or made exact. */
export class Variation extends Designed<VariationHandle> {
  readonly #core: Core;

  /** @internal Use Family.at(). */
  constructor(core: Core, make: () => VariationHandle) {
    const place = new Place(core.pool, make);
    super(core, place.handle);
    place.keepIfStopped(this.report.status);
    this.#core = core;
  }

  /** The nearest mesh whose panels are all flat. */
  exact({ progress }: { readonly progress?: Progress } = {}): Variation {
    return new Variation(this.#core, () => insist(this.handle().exact(progress ?? null)));
  }
}
