// SPDX-License-Identifier: MIT
// What drag_bindings.cpp lists, by hand. Handles are vertex, x, y, z for each.

import type { Session } from "./planish.d.ts";
import type { EnumValue } from "./planish_designs.d.ts";

/** What holds a drag back beside the limits of its options. */
export interface PullBounds {
  /** By how much of the longest way handles may stop short in any case. */
  readonly short: number;
  /** The handles at the start of the drag, in the order of its targets. */
  readonly from: readonly number[];
  /** Edits that a search for how far it lets handles go may take beside the first, where not as many as usual. */
  readonly tries?: number;
}

/** Where the edit that is shown stands with its handles. */
export interface PullStanding {
  /** It found no way to move, or only a part of the way. */
  readonly isStuck: boolean;
  /** A panel or a point is at a limit. */
  readonly isBound: boolean;
  /** Handles got as far as they were asked to, or are not kept from it by a limit. */
  readonly arrives: boolean;
  /** They are not there only because a frame's time was over. */
  readonly lags: boolean;
}

export interface Pulled {
  /** "" where all is well. */
  readonly problem: string;
  /** Of "near". */
  readonly suffices: boolean;
  /** Where handles were taken back to; null where they are as asked. */
  readonly taken: Float64Array | null;
}

export interface DragModule {
  /** How handles are pulled: by a frame of a drag, which may take the time of several to catch up (`follow`); by one that is
   * kept where no more panels need to follow, else what is shown is the edit kept before (`near`); by one that limits may
   * hold back (`hold`); as far as they get, the end of the way by a release or a solve (`release`, `furthest`). */
  PullWay: {
    follow: EnumValue;
    near: EnumValue;
    hold: EnumValue;
    release: EnumValue;
    furthest: EnumValue;
  };
  pull(
    session: Session,
    way: EnumValue,
    handles: Float64Array,
    pins: Int32Array,
    continuation: number,
    budgetSeconds: number,
    limit: PullBounds,
  ): Pulled;
  /** How the last "hold" ended: whether it was of a pull from there, and held back from `to`; the handles kept last. */
  lastPull(
    session: Session,
    from: Float64Array,
    to: Float64Array,
  ): { readonly goesOn: boolean; readonly isHeldBack: boolean; readonly taken: Float64Array };
  /** No drag goes on. */
  forgetDrag(session: Session): void;
  pullStanding(session: Session, handles: Float64Array, limit: PullBounds): PullStanding;
  /** Whether more panels need not follow: handles stop short by `most` of their way at most, nothing is at a limit, no
   * fold gets unfair. */
  suffices(session: Session, way: number, most: number): boolean;
}
