// SPDX-License-Identifier: MIT
// A drag is held back where panels would fold much sharper than those of the base do, and where limits
// that are stated do not let its handles follow.
import { foldGrowth } from "./fair-folds.ts";
import type { HandleList, PullLimit, ShapeReport } from "./protocol.ts";

/** Whether an edit is within the limit; one that found no way to move is not. */
export function isWithin({ degrees, short }: PullLimit, report: ShapeReport): boolean {
  const { status, movedVertices, handleError, maxDisplacement } = report;
  if (status === "iteration_limit" && movedVertices === 0) return false;
  // ∞ · 0 is no number, and nothing exceeds that.
  return foldGrowth(report) <= degrees && !(handleError > short * maxDisplacement);
}

/**
 * An edit of these handles; whether it is within the limit. A frame follows the edit before it; a
 * `settled` one follows what was taken last, so that an edit that is not leaves nothing behind.
 */
export type Attempt = (handles: HandleList, settled: boolean) => boolean;

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
  /** That of the last edit. */
  #at = Number.NaN;

  /**
   * Edits as far towards `to` as the limit allows; the handles of the last edit. Once a search took
   * more than `milliseconds`, frames are not held back any more, so that a drag on a fine mesh goes on;
   * its end, which has no such limit, still is.
   */
  take(
    from: HandleList,
    to: HandleList,
    attempt: Attempt,
    milliseconds = Number.POSITIVE_INFINITY,
  ): HandleList {
    const until = performance.now() + milliseconds;
    const over = (): boolean => performance.now() >= until;
    if (this.#slow && milliseconds < Number.POSITIVE_INFINITY) {
      attempt(to, false);
      return to;
    }
    const way = wayOf(from, to);
    const length = Math.sqrt(dot(way, way));
    const guess = this.#turn(from, way, length);
    const holds = (tried: number, settled: boolean): boolean => {
      this.#at = tried;
      return attempt(between(from, to, length > 0 ? tried / length : 1), settled);
    };
    // A frame that follows one which held is cheap; a search takes several.
    if (guess < length && holds(guess, false)) {
      this.#held = guess;
      return between(from, to, guess / length);
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
    const known = this.#held < this.#broke ? this.#held : 0;
    this.#held = this.#search(known, length, over, holds);
    if (over()) {
      this.#slow = true;
      attempt(to, false);
      return to;
    }
    this.#back = this.#held;
    return between(from, to, this.#held / length);
  }

  /** Another drag, or another direction. What held a drag back before may hold it back here. */
  #turn(from: HandleList, way: readonly number[], length: number): number {
    const key = from.join();
    const before = Math.sqrt(dot(this.#way, this.#way));
    const cosine = key === this.#from ? dot(way, this.#way) / (length * before) : -1;
    this.#from = key;
    this.#way = way;
    if (cosine >= SAME_WAY) return Number.POSITIVE_INFINITY;
    const guess = this.#back > 0 && cosine >= SIMILAR_WAY ? this.#back : Number.POSITIVE_INFINITY;
    [this.#held, this.#broke, this.#at] = [0, Number.POSITIVE_INFINITY, Number.NaN];
    return guess;
  }

  #search(
    known: number,
    length: number,
    over: () => boolean,
    holds: (tried: number, settled: boolean) => boolean,
  ): number {
    let low = known;
    for (let k = 0; k < TRIES && this.#broke - low > FINE * length; ++k) {
      if (over()) return low;
      // From below: edits that fold little are found soon, those that fold much late.
      const tried = low > 0 ? Math.min(LEAP * low, (low + this.#broke) / 2) : this.#broke / START;
      if (holds(tried, true)) low = tried;
      else this.#broke = tried;
    }
    if (this.#at === low || over() || holds(low, true) || low === 0) return low;
    // It held in a frame only, on the way there.
    this.#broke = low;
    return this.#search(0, length, over, holds);
  }
}
