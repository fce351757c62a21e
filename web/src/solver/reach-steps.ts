// SPDX-License-Identifier: MIT
// The smallest reach with which an edit is no worse than it has to be: in one drag it grows, and stays.
import type { HandleList } from "./protocol.ts";

/** Panels around the handles. The last is the page's first setting, whatever it costs. */
export const REACHES: readonly number[] = [2, 3, 4, 6];

/** The reach of one drag. */
export class ReachSteps {
  #from = "";
  #step = 0;
  #reaches: readonly number[] = [];

  /** Whether this is another drag, which begins with the first of `reaches`. */
  begins(from: HandleList, reaches: readonly number[]): boolean {
    if (this.#from === from.join()) return false;
    this.#from = from.join();
    this.#reaches = reaches;
    this.#step = 0;
    return true;
  }

  /** null: that of the settings. */
  get now(): number | null {
    return this.#reaches[this.#step] ?? null;
  }

  get isLast(): boolean {
    return this.#step >= this.#reaches.length - 1;
  }

  grow(): void {
    this.#step += 1;
  }
}
