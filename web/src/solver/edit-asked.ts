// SPDX-License-Identifier: MIT
// What an edit is asked with, between the page and the solver worker.

import type { EditOptions, PullBounds } from "@wasm/planish.mjs";

export type { SoughtLimits } from "@wasm/planish.mjs";

export type Fairness = EditOptions["fairness"];
export type EditMode = "drag" | "release" | "solve";

/** Targets in model units. `handles`: vertex, x, y, z for each. */
export interface Targets {
  readonly handles: readonly number[];
  readonly pins: readonly number[];
}

/** The core's options, and what it counts among the targets. */
export interface EditSettings extends EditOptions {
  /** What points stand on, as the command line's --support says it: "level=z:3,4". */
  readonly supports: readonly string[];
  /** Steps in which typed targets are approached; 0: at once. The end of a drag chooses it. */
  readonly continuation: number;
  /** Under which edits have images, as --symmetry says it, one each. */
  readonly symmetry: readonly string[];
  /** Made on the flat mesh before every edit, in this order, as --cut says them. */
  readonly cuts: readonly string[];
}

/** Handles are vertex, x, y, z for each, model units. */
export type HandleList = readonly number[];

export interface PullLimit extends PullBounds {
  /** By which any fold may sharpen; ∞: the drag's own limit on folds does not act. */
  readonly degrees: number;
  /** Where the base has the handles. */
  readonly base: HandleList;
}
