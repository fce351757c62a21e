// SPDX-License-Identifier: MIT
// A drag is held back where its limits, bounds of every frame, do not let its handles follow.
import { boundNames } from "./bounds.ts";
import { foldGrowth } from "./found-limits.ts";
import { type Arrival, MET } from "./how-far.ts";
import type { HandleList, PullLimit, ShapeReport } from "./protocol.ts";

/** The limit on folds that acts on the drag alone; null: none. */
export const ownBound = ({ degrees }: PullLimit): string | null =>
  degrees < Number.POSITIVE_INFINITY ? `fold=+${degrees}` : null;

export const isBound = (report: ShapeReport): boolean => boundNames(report).length > 0;

/** Whether an edit found no way to move, or only a part of the way. */
export const isStuck = ({ status, movedVertices }: ShapeReport): boolean =>
  status === "infeasible_handles" || (status === "iteration_limit" && movedVertices === 0);

/** The way of the handle that goes furthest from its base. */
export function longestWay(base: HandleList, handles: HandleList): number {
  let longest = 0;
  for (let k = 0; k < handles.length; k += 4) {
    const way = [1, 2, 3].map((axis) => (handles[k + axis] ?? 0) - (base[k + axis] ?? 0));
    longest = Math.max(longest, Math.hypot(...way));
  }
  return longest;
}

/** Of the limit's `share`: where nothing binds, handles are as far as they get for other reasons. */
const allowed = ({ short }: PullLimit): number => Math.max(MET, short);

/** Whether the handles of an edit got as far as they were asked to, or are not kept from it by a limit. */
export function arrives(limit: PullLimit, handles: HandleList, report: ShapeReport): boolean {
  if (isStuck(report)) return false;
  return !isBound(report) || report.handleError <= allowed(limit) * longestWay(limit.base, handles);
}

/** Whether handles are not there only because a frame's time was over. */
export const lags = (limit: PullLimit, handles: HandleList, report: ShapeReport): boolean =>
  report.status === "iteration_limit" &&
  !isBound(report) &&
  report.handleError > allowed(limit) * longestWay(limit.base, handles);

/** How far handles stop short, and beyond what `limit` allows, as shares of a pull `length` long. */
export function arrivalOf(
  limit: PullLimit,
  handles: HandleList,
  report: ShapeReport,
  length: number,
): Arrival {
  const over = report.handleError - allowed(limit) * longestWay(limit.base, handles);
  const least = isStuck(report) || (isBound(report) && over > 0) ? Number.MIN_VALUE : 0;
  return {
    short: report.handleError / length,
    over: least > 0 ? Math.max(least, over / length) : Math.min(0, over / length),
  };
}

/** Whether an edit without the drag's own limit keeps it. */
export const keepsOwn = ({ degrees }: PullLimit, report: ShapeReport): boolean =>
  foldGrowth(report) <= degrees;
/** Edits that one frame may try beyond the first. */
const TRIES = 5;
/** Share of the pull: finer is not seen. */
const FINE = 0.02;
/** Of what held: a pull this many times as long is not worth an edit of its own. */
const LEAP = 2;
/** The first try where nothing is known: this part of the pull. */
const START = 8;
/** Cosine: pulls that differ more say nothing about each other. */
const SAME_WAY = 0.99;
/** Cosine: down to this, what held one way is worth a try the other way. */
const SIMILAR_WAY = 0.5;

/** `to` itself, bit by bit, at 1. */
export const between = (from: HandleList, to: HandleList, share: number): number[] =>
  to.map((x, k) => {
    const start = from[k] ?? x;
    return share === 1 || x === start ? x : start + share * (x - start);
  });

const wayOf = (from: HandleList, to: HandleList): number[] => to.map((x, k) => x - (from[k] ?? x));
const dot = (a: readonly number[], b: readonly number[]): number =>
  a.reduce((sum, x, k) => sum + x * (b[k] ?? 0), 0);

/** Edits of a drag, which follow each other. */
export interface Frames {
  /** Whether the handles arrive. A `settled` one follows the edit kept last in place of the last one. */
  edit(handles: HandleList, settled: boolean): boolean;
  /** Keeps the last edit. */
  keep(): void;
  /** Shows the one kept. */
  back(): void;
}

/** Remembers, from frame to frame of one drag, how far its pull may go. */
export class PullHold {
  #from = "";
  #way: readonly number[] = [];
  /** Lengths of pulls this way: the longest that held, the shortest that did not. */
  #held = 0;
  #broke = Number.POSITIVE_INFINITY;
  /** To which a pull was taken back last, whichever way; 0 if the last one held. */
  #back = 0;
  #slow = false;
  /** Of the edit kept: the length of its pull, if that is this way, and its handles. */
  #at = Number.NaN;
  #taken: HandleList = [];
  /** Whether it is the one that is shown. */
  #isShown = true;

  /** Where the last pull went to, if it was held back. */
  #heldBack: string | null = null;

  /** The handles of the edit kept last: of the longest pull this way that arrived. */
  get taken(): HandleList {
    return this.#taken;
  }

  /** Whether the last pull was to `to`, and held back. */
  heldBackFrom(to: HandleList): boolean {
    return this.#heldBack === to.join();
  }

  /** Whether frames of the pull that starts there were made. */
  goesOn(from: HandleList): boolean {
    return this.#from === from.join();
  }

  /**
   * Edits as far towards `to` as the limit allows; the handles of the edit that is shown then. Once a
   * search took more than `milliseconds`, nothing is looked for any more, so that a drag on a fine mesh
   * goes on: where a frame does not arrive, they are those of the last that did.
   */
  take(from: HandleList, to: HandleList, frames: Frames, milliseconds: number): HandleList {
    const taken = this.#take(from, to, frames, milliseconds);
    this.#heldBack = taken === to ? null : to.join();
    return taken;
  }

  #take(from: HandleList, to: HandleList, frames: Frames, milliseconds: number): HandleList {
    if (this.#slow) return frames.edit(to, false) ? to : this.#taken;
    const until = performance.now() + milliseconds;
    const over = (): boolean => performance.now() >= until;
    if (!this.goesOn(from)) {
      frames.keep();
      this.#taken = from;
    }
    const way = wayOf(from, to);
    const length = Math.sqrt(dot(way, way));
    const guess = this.#turn(from, way, length);
    const holds = (tried: number, settled: boolean): boolean => {
      const handles = tried === length ? to : between(from, to, tried / length);
      this.#isShown = frames.edit(handles, settled);
      if (!this.#isShown) return false;
      frames.keep();
      [this.#at, this.#taken] = [tried, handles];
      return true;
    };
    // A frame that follows one which held is cheap; a search takes several.
    if (guess < length && holds(guess, false)) {
      this.#held = guess;
      return this.#taken;
    }
    this.#back = 0;
    if (length < this.#broke) {
      const leaps = this.#held > 0 && length > LEAP * this.#held;
      if (holds(length, false) || (!leaps && holds(length, true))) {
        this.#held = Math.max(this.#held, length);
        return to;
      }
      this.#broke = length;
    }
    this.#search(length, over, holds);
    if (!this.#isShown) frames.back();
    this.#isShown = true;
    this.#slow = over();
    this.#back = this.#held;
    return this.#taken;
  }

  /** Another drag, or another direction. What held a drag back before may hold it back here. */
  #turn(from: HandleList, way: readonly number[], length: number): number {
    const before = Math.sqrt(dot(this.#way, this.#way));
    const cosine = this.goesOn(from) ? dot(way, this.#way) / (length * before) : -1;
    this.#from = from.join();
    this.#way = way;
    if (cosine >= SAME_WAY) return Number.POSITIVE_INFINITY;
    const guess = this.#back > 0 && cosine >= SIMILAR_WAY ? this.#back : Number.POSITIVE_INFINITY;
    [this.#held, this.#broke, this.#at] = [0, Number.POSITIVE_INFINITY, Number.NaN];
    return guess;
  }

  /** The longest that holds, between what held and what did not; nothing where none does. */
  #search(
    length: number,
    over: () => boolean,
    holds: (tried: number, settled: boolean) => boolean,
  ): void {
    let low = this.#held < this.#broke ? this.#held : 0;
    for (let k = 0; k < TRIES && this.#broke - low > FINE * length && !over(); ++k) {
      // Tried from below: edits that fold little are found soon, those that fold much late.
      const tried = low > 0 ? Math.min(LEAP * low, (low + this.#broke) / 2) : this.#broke / START;
      if (holds(tried, true)) low = tried;
      else this.#broke = tried;
    }
    // A share that held before, of which the last frames came back, or the base of a pull that turned.
    if (this.#at !== low && !over() && !holds(low, true) && low > 0) {
      this.#broke = low;
      low = Number.isNaN(this.#at) ? 0 : this.#at;
    }
    this.#held = low;
  }
}
