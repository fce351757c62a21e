// SPDX-License-Identifier: MIT
// One page: what it shows, and what its parts keep. Every function that reads or changes any of it takes
// the page first; nothing else outlives a call.
import type { SpawnWorker } from "../solver/client.ts";
import { PageState } from "./page-state.ts";

export class Page extends PageState {
  /** Starts a solver. */
  readonly spawn: SpawnWorker;
  readonly #parts = new Map<unknown, unknown>();

  constructor(spawn: SpawnWorker) {
    super();
    this.spawn = spawn;
  }

  /** What `make` made for this page, when it was first asked for. */
  part<T>(make: (page: Page) => T): T {
    if (!this.#parts.has(make)) this.#parts.set(make, make(this));
    return this.#parts.get(make) as T;
  }
}

/** Something that a page has once, made when it is first asked for. */
export const kept =
  <T>(make: (page: Page) => T) =>
  (page: Page): T =>
    page.part(make);
