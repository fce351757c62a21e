// SPDX-License-Identifier: MIT
// What is tried beside a way to planarise that takes long: what there is near the file, quickest first.

import type { Design } from "../../design/design.ts";
import type { Trial } from "../../design/planarising.ts";
import type { OpenedMesh, Planarising } from "../../solver/protocol.ts";
import { GivenUp } from "../../solver/second-solver.ts";
import { isMet } from "./is-met.ts";
import type { PlanariseTrials } from "./planarise-trial.ts";
import { nearWay, quickWay } from "./stops.ts";

/** Milliseconds before each trial: what someone does meanwhile may make an end of it. */
const PAUSE_MS = 150;

type Told = (near: Trial) => void;

export class Beside {
  readonly #trials: PlanariseTrials;
  readonly #opened: OpenedMesh;
  readonly #design: Design;
  readonly #split: number;
  readonly #ways: readonly Planarising[];
  readonly #told: Told;
  #running: Promise<Trial | null> | null = null;
  /** Nobody waits any more: nothing else is begun. */
  #givenUp = false;
  /** The last of several ways, which is quick on some meshes where the first takes long. */
  #last: Promise<Trial | null> | null = null;
  /** Who asks for what is tried here tries the last way, too. */
  #lastIsTaken: boolean;

  /**
   * @param ways what is asked for, the first first
   * @param told gets what there is on the way, whoever asks for it
   */
  constructor(
    trials: PlanariseTrials,
    opened: OpenedMesh,
    design: Design,
    split: number,
    ways: readonly Planarising[],
    told: Told,
  ) {
    this.#trials = trials;
    this.#opened = opened;
    this.#design = design;
    this.#split = split;
    this.#ways = ways;
    this.#told = told;
    this.#lastIsTaken = ways.length < 2;
  }

  /** What came of the last way, if it is tried here; null: from now on it is not. */
  takeLast(): Promise<Trial | null> | null {
    this.#lastIsTaken = true;
    return this.#last;
  }

  /** What runs ends with its worker. */
  end(): void {
    this.#givenUp = true;
    this.#trials.end();
  }

  /** Once, whoever asks first. What there is in the end; null where distances or flatness are stated
   * already, and where there is nothing. */
  run(): Promise<Trial | null> {
    this.#running ??= this.#run();
    return this.#running;
  }

  async #run(): Promise<Trial | null> {
    const [asked, last] = [this.#ways[0], this.#ways.at(-1)];
    if (!asked || !last || this.#split > 0 || asked.within > 0 || asked.flat > 0) return null;
    // A boundary that stays is quicker near the file; one that may move lets panels get flatter.
    const quick = await this.#instead(quickWay(asked, this.#opened));
    if (quick) this.#told(quick);
    if (!this.#lastIsTaken) {
      this.#last = this.#try(last);
      const exact = await this.#last;
      if (exact && isMet(exact, this.#design)) {
        this.#told(exact);
        return exact;
      }
    }
    const near = await this.#instead(nearWay(last, this.#opened));
    if (near) this.#told(near);
    return near ?? quick;
  }

  async #instead(how: Planarising): Promise<Trial | null> {
    const trial = await this.#try(how);
    return trial && { ...trial, instead: true };
  }

  /** null where it is refused or given up. */
  async #try(how: Planarising): Promise<Trial | null> {
    await new Promise((resolve) => setTimeout(resolve, PAUSE_MS));
    if (this.#givenUp) return null;
    const { source, settings } = this.#design;
    const wanted = { source, cuts: settings.cuts, how, split: 0 };
    return this.#trials.run(wanted).catch((error: unknown) => {
      this.#givenUp ||= error instanceof GivenUp;
      return null;
    });
  }
}
