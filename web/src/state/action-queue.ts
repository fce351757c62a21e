// SPDX-License-Identifier: MIT
// Actions that change the design stand in a queue: each starts from what the one before it left.
import type { Result } from "../result/result.ts";
import { kept, type Page } from "./page.ts";
import { report } from "./telling.ts";

/** What comes of a queued action; undefined: nothing that changes what was said before. */
export type Outcome<T = unknown> = Promise<Result<T> | undefined>;

interface Queued {
  readonly burst: string | null;
  begun: boolean;
  overtaken: boolean;
}

interface Own {
  last: Promise<void>;
  newest: Queued | null;
  /** Counts how often what waited was dropped. */
  era: number;
}

const own = kept((): Own => ({ last: Promise.resolve(), newest: null, era: 0 }));

/**
 * Runs `action` after those that wait already, unless they are dropped first. Of actions of one
 * burst that wait one after the other only the last is done: keys come faster than results.
 * What comes of it is reported to whoever asked, here and nowhere else.
 * @returns undefined if it was dropped
 */
export function enqueue<T>(
  page: Page,
  action: () => Outcome<T>,
  burst: string | null = null,
): Outcome<T> {
  const queue = own(page);
  const mine = queue.era;
  const { newest } = queue;
  const queued: Queued = { burst, begun: false, overtaken: false };
  if (newest && burst !== null && newest.burst === burst && !newest.begun) newest.overtaken = true;
  queue.newest = queued;
  page.queued.value += 1;
  const done = queue.last.then(async () => {
    queued.begun = true;
    const result = mine === queue.era && !queued.overtaken ? await action() : undefined;
    if (result) report(page, result);
    return result;
  });
  queue.last = done
    .catch(() => undefined)
    .then(() => {
      if (mine === queue.era) page.queued.value -= 1;
    });
  return done;
}

/** Forgets the actions that have not started. */
export function dropQueued(page: Page): void {
  own(page).era += 1;
  page.queued.value = 0;
}

/** Holds back the actions that are still to come until `done`; itself it is none. */
export function holdQueue(page: Page, done: Promise<unknown>): void {
  const queue = own(page);
  queue.last = queue.last
    .then(() => done)
    .then(
      () => undefined,
      () => undefined,
    );
}
