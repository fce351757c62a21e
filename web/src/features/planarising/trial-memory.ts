// SPDX-License-Identifier: MIT
import { sameWay, type Trial } from "../../design/planarising.ts";
import type { Planarising } from "../../solver/protocol.ts";

/** Which way was tried. */
interface Way {
  readonly how: Planarising;
  /** How many panels may be split for it. */
  readonly split: number;
}

/** What was tried of one mesh, so that nobody waits for it twice. */
export class TrialMemory {
  readonly #most: number;
  readonly #known: (readonly [Way, Trial])[] = [];

  /** @param most trials that are kept: each holds a mesh */
  constructor(most: number) {
    this.#most = most;
  }

  keep({ how, split }: Way, trial: Trial): void {
    this.#known.push([{ how, split }, trial]);
    if (this.#known.length > this.#most) this.#known.shift();
  }

  find({ how, split }: Way): Trial | null {
    const same = this.#known.find(([way]) => way.split === split && sameWay(way.how, how));
    return same?.[1] ?? null;
  }
}
