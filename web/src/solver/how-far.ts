// SPDX-License-Identifier: MIT
// How far along a pull the handles of an edit get whose limits are bounds of the solve.

/** Share of its way: as near to its target a handle meets it. */
export const MET = 0.05;
/** Share of its way: a handle that stops short by less is not said to. Soft handles stop short by a hundredth, raw weights by a tenth. */
export const NOTICEABLE = 0.15;
/** Edits beside the one at the end of the pull. */
const TRIES = 4;
/** The ratio of a share that is not met to one that is: finer is not looked for. */
const FINE = 1.03;
/** The next share beyond one that is met closely, and beyond one that is met with ease: the line to one
 * that is not met says little where the two are of different minima. */
const FURTHER = { close: 1.2, easy: 1.5 };
/** Of shares: from here on the two are of different minima. */
const WIDE = 1.3;
/** Handles that stop up to `most` times as short as they may nearly meet their targets; their share counts
 * `worth` of its length. */
const NEARLY = { most: 3, worth: 0.5 };
/** Of a share at which handles get nowhere: the next. */
const BACK = 0.4;

/** An edit of a share of a pull, whose whole length is 1. */
export interface Arrival {
  /** By how much its handles stop short. */
  readonly short: number;
  /** By how much more than they may; up to 0 the share is met. */
  readonly over: number;
}

interface Tried extends Arrival {
  readonly share: number;
}

/** Makes edits of shares of a pull. */
export interface Puller {
  edit(share: number): Arrival;
  /** Keeps the last edit. */
  keep(): void;
  /** Makes the one kept the last one again. */
  back(): void;
}

/**
 * The share of a pull that the edit made last is of: the largest that was found to be met, or one that is
 * nearly met where handles get much further by it; where there is none, the smallest that was tried. The
 * end of the pull is tried first: where it is not met, what its handles reach says about where others are.
 */
export function furthest(puller: Puller, tries = TRIES): number {
  let best: Tried | null = null;
  const attempt = (share: number): Tried => {
    const tried = { share, ...puller.edit(share) };
    if (worth(tried) > (best ? worth(best) : 0)) {
      best = tried;
      puller.keep();
    }
    return tried;
  };
  let [low, high]: [Tried | null, Tried] = [null, attempt(1)];
  if (high.over <= 0) return 1;
  let beyond: Tried | null = null;
  let last = high;
  for (let k = 0; k < tries && high.share > FINE * (low?.share ?? 0); ++k) {
    last = attempt(low ? between(low, high) : before(high, beyond));
    if (last.over <= 0) low = last;
    else [beyond, high] = [high, last];
  }
  if (best && last !== best) puller.back();
  return (best ?? last).share;
}

const allowed = ({ short, over }: Tried): number => short - over;

/** How far handles get, and less of it where they do not meet their targets; 0 where they are far off. */
function worth(tried: Tried): number {
  const reached = tried.share - tried.short;
  if (tried.over <= 0) return reached;
  return tried.short <= NEARLY.most * allowed(tried) ? NEARLY.worth * reached : 0;
}

/** The share to try where none is met yet: on the line through the last two, about where the handles stopped. */
function before(high: Tried, beyond: Tried | null): number {
  const { share, short, over } = high;
  if (short >= share) return BACK * share;
  const slope = beyond ? (beyond.over - over) / (beyond.share - share) : Number.POSITIVE_INFINITY;
  const line = slope > 0 ? share - over / slope : 0;
  return Math.max(share - 2 * short, Math.min(share - short, line));
}

/** A share between two: on the line, where they are alike, and at the middle at most. */
function between(low: Tried, high: Tried): number {
  const gap = high.share - low.share;
  const middle = low.share + gap / 2;
  const line = low.share - (low.over * gap) / (high.over - low.over);
  if (high.share < WIDE * low.share)
    return high.over > allowed(high)
      ? middle
      : Math.min(middle, Math.max(line, low.share + gap / 4));
  const further = low.short > allowed(low) / 2 ? FURTHER.close : FURTHER.easy;
  return Math.min(middle, Math.max(line, further * low.share));
}
