// SPDX-License-Identifier: MIT
// Actions that change the design take turns: each starts from what the one before it left.
import { signal } from "@preact/signals";

interface Turn {
  readonly burst: string | null;
  begun: boolean;
  overtaken: boolean;
}

let last: Promise<void> = Promise.resolve();
let newest: Turn | null = null;
let era = 0;

/** Actions that run or wait and have not been dropped. */
export const turnsLeft = signal(0);

/**
 * Runs `action` after those that wait already, unless they are dropped first. Of actions of one
 * burst that wait one after the other only the last is done: keys come faster than results.
 */
export function inTurn(action: () => Promise<void>, burst: string | null = null): Promise<void> {
  const mine = era;
  const turn: Turn = { burst, begun: false, overtaken: false };
  if (newest && burst !== null && newest.burst === burst && !newest.begun) newest.overtaken = true;
  newest = turn;
  turnsLeft.value += 1;
  const done = last.then(() => {
    turn.begun = true;
    return mine === era && !turn.overtaken ? action() : undefined;
  });
  last = done
    .catch(() => undefined)
    .then(() => {
      if (mine === era) turnsLeft.value -= 1;
    });
  return done;
}

/** Forgets the actions that have not started. */
export function dropTurns(): void {
  era += 1;
  turnsLeft.value = 0;
}

/** Holds back the actions that are still to come until `done`; itself it is none. */
export function holdTurns(done: Promise<unknown>): void {
  last = last
    .then(() => done)
    .then(
      () => undefined,
      () => undefined,
    );
}
