// SPDX-License-Identifier: MIT
// What each other way to make a mesh flat costs: tried one after the other beside what is shown, which
// stays as it is.

import { signal } from "@preact/signals";
import type { Design } from "../../design/design.ts";
import type { Trial } from "../../design/planarising.ts";
import type { OpenedMesh, Planarising } from "../../solver/protocol.ts";
import { excessesOf, isMet, serves } from "./is-met.ts";
import type { PlanariseTrials } from "./planarise-trial.ts";
import { nearWay, splitMost } from "./stops.ts";

/** One press. */
export interface OtherWay {
  readonly label: string;
  readonly how: Planarising;
  /** Percent of the panels that may be split. */
  readonly share: number;
}

export interface Cost {
  /** Whether the way does as it says: panels become as flat as it asks for, or points stay within a distance. */
  readonly met: boolean;
  /** Model units. */
  readonly move: number;
  /** Of the panel that is least flat. */
  readonly mmPerM: number;
  /** Panels that are not flat; null where nobody measured them. */
  readonly bent: number | null;
  readonly split: number;
}

interface Costs {
  /** By the ways' labels; null: refused. */
  readonly known: ReadonlyMap<string, Cost | null>;
  readonly done: boolean;
}

/** Where what is near the file stands for a way, what counts is what that way itself asks for. */
function costOf(trial: Trial, { how }: OtherWay, design: Design): Cost {
  const { mesh, measures, split } = trial;
  const { report } = mesh;
  const flat = design.settings.tolerance;
  const excesses = measures && excessesOf(measures.figures);
  return {
    met: how.within > 0 || isMet({ ...trial, how }, design),
    move: report.planarising.largest,
    mmPerM: report.worstExcess > flat ? report.worstMmPerM : 0,
    bent: excesses?.filter((excess) => excess > flat).length ?? null,
    split: split?.panels ?? 0,
  };
}

/** Those that do as they say first, of these the least move; a way whose cost is not known stays behind, one
 * that was refused is left out where there is another. */
export function byCost(
  ways: readonly OtherWay[],
  costs: ReadonlyMap<string, Cost | null>,
): readonly OtherWay[] {
  const open = ways.filter(({ label }) => costs.get(label) !== null);
  const rank = ({ label }: OtherWay): number => {
    const cost = costs.get(label);
    return cost ? Number(!cost.met) : 2;
  };
  const move = ({ label }: OtherWay): number => costs.get(label)?.move ?? 0;
  return [...(open.length > 0 ? open : ways)].sort(
    (a, b) => rank(a) - rank(b) || move(a) - move(b),
  );
}

export class WayCosts {
  readonly now = signal<Costs | null>(null);
  readonly #trials: PlanariseTrials;
  readonly #opened: OpenedMesh;
  readonly #design: Design;
  /** Counts what was wanted. */
  #newest = 0;

  constructor(trials: PlanariseTrials, opened: OpenedMesh, design: Design) {
    this.#trials = trials;
    this.#opened = opened;
    this.#design = design;
  }

  /** Gives up what runs; what was found is forgotten. */
  end(): void {
    this.#newest += 1;
    this.#trials.end();
    this.now.value = null;
  }

  /** Tries all of `ways`, in this order. */
  async find(ways: readonly OtherWay[]): Promise<void> {
    this.end();
    const mine = this.#newest;
    const known = new Map<string, Cost | null>();
    this.now.value = { known, done: false };
    for (const way of ways) {
      const trial = await this.#try(way, mine);
      if (mine !== this.#newest) return;
      known.set(way.label, trial && costOf(trial, way, this.#design));
      this.now.value = { known: new Map(known), done: false };
    }
    this.#trials.end();
    this.now.value = { known, done: true };
  }

  /** What a press would show. */
  async #try({ how, share }: OtherWay, mine: number): Promise<Trial | null> {
    const trial = await this.#run(how, splitMost(share, this.#opened));
    if (share > 0 || how.within > 0 || how.flat > 0 || mine !== this.#newest) return trial;
    if (trial && serves(trial, this.#design, this.#opened)) return trial;
    return (await this.#run(nearWay(how, this.#opened), 0)) ?? trial;
  }

  /** null where it is refused or given up. */
  #run(how: Planarising, split: number): Promise<Trial | null> {
    const { source, settings } = this.#design;
    return this.#trials.run({ source, cuts: settings.cuts, how, split }).catch(() => null);
  }
}
