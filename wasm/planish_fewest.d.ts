// SPDX-License-Identifier: MIT
// What fewest_bindings.cpp lists, by hand.

import type { Session } from "./planish.d.ts";
import type { SplitModule } from "./planish_cuts.d.ts";
import type { DragModule } from "./planish_drag.d.ts";
import type { FairModule } from "./planish_fair.d.ts";

export type * from "./planish_drag.d.ts";
export type * from "./planish_fair.d.ts";

/** The edit that makes few panels again, beside its shape. */
export interface FewestFound {
  /** To be made again. */
  readonly panels: number;
  /** Points held beside the pins that were asked for, ascending. */
  readonly held: Int32Array;
  /** The handles arrive; if not, nothing is held. */
  readonly reached: boolean;
  /** With any one more held, they do not. */
  readonly minimal: boolean;
  readonly solves: number;
  /** Of the edit: those of its options, and those that keep panels such that they can be built. */
  readonly limits: readonly string[];
}

/** What looks for other edits in place of one: with panels split, with limits, nearer, or with few to make again. */
export interface EditWays extends SplitModule, FairModule, DragModule {
  /** Shows the edit that makes few panels again. `withinHandle`: of the longest way of a handle, so near
   * to their targets handles have arrived; `mostPanels`: enough of them, 0 for as few as can be. What it
   * holds are pins from here on, its limits options. */
  fewest(
    session: Session,
    handles: Float64Array,
    pins: Int32Array,
    withinHandle: number,
    mostPanels: number,
  ): string;
  /** What the last fewest() found. */
  fewestFound(session: Session): FewestFound;
}
