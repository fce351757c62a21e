// SPDX-License-Identifier: MIT
// Actions that change the design take turns: each starts from what the one before it left.

let last: Promise<void> = Promise.resolve();
let era = 0;

/** Runs `action` after those that wait already, unless they are dropped first. */
export function inTurn(action: () => Promise<void>): Promise<void> {
  const mine = era;
  const turn = last.then(() => (mine === era ? action() : undefined));
  last = turn.catch(() => undefined);
  return turn;
}

/** Forgets the actions that have not started. */
export function dropTurns(): void {
  era += 1;
}
