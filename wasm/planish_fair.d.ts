// SPDX-License-Identifier: MIT
// What fair_bindings.cpp lists, by hand.

import type { Session } from "./planish.d.ts";
import type { EnumValue } from "./planish_designs.d.ts";

/** What an edit gets unasked, where that costs its handles nothing. */
export interface SoughtLimits {
  /** Of the handle that goes furthest, from the base to its target; model units. */
  readonly way: number;
  /** A limit on how much folds sharpen. */
  readonly folds: boolean;
  /** The limit on corners with which panels can be built. */
  readonly corners: boolean;
}

export interface FairModule {
  /** Session.edit() with the limits that cost its handles nothing: options from here on. */
  editFairly(
    session: Session,
    mode: EnumValue,
    handles: Float64Array,
    pins: Int32Array,
    continuation: number,
    budgetSeconds: number,
    sought: SoughtLimits,
  ): string;
  /** Those that the last editFairly() found, as --bound says them. */
  fairFound(session: Session): readonly string[];
}
