// SPDX-License-Identifier: MIT
// What planarising would make of the opened mesh, computed beside the solver that holds it.

import type { Trial } from "../../design/planarising.ts";
import type { SpawnWorker } from "../../solver/client.ts";
import type { Planarising, Source } from "../../solver/protocol.ts";
import { type Ask, type News, SecondSolver } from "../../solver/second-solver.ts";
import type { TrialMemory } from "./trial-memory.ts";

/** Of which mesh, and how. */
interface Wanted {
  readonly source: Source;
  readonly cuts: readonly string[];
  readonly how: Planarising;
  /** How many panels may be split for it; 0: none. */
  readonly split: number;
}

type Said = (step: number) => void;

const told =
  (said: Said) =>
  (news: News): void => {
    if (news.kind === "progress") said(news.step);
  };

export class PlanariseTrials {
  readonly #solver: SecondSolver;
  readonly #memory: TrialMemory;

  /** @param memory of the one mesh that they are about */
  constructor(spawn: SpawnWorker, memory: TrialMemory) {
    this.#solver = new SecondSolver(spawn);
    this.#memory = memory;
  }

  /** The newest wins. @param said gets the number of steps so far
   * @throws GivenUp, or an Error with the sentence of the refusal */
  async run(wanted: Wanted, said: Said = () => {}): Promise<Trial> {
    const known = this.#memory.find(wanted);
    if (known) {
      this.#solver.end();
      return known;
    }
    const trial = await this.#solver.run((ask) =>
      wanted.split > 0 ? splitting(ask, wanted, said) : whole(ask, wanted, said),
    );
    this.#memory.keep(wanted, trial);
    return trial;
  }

  /** Gives up what runs and lets the worker go. */
  end(): void {
    this.#solver.end();
  }
}

async function whole(ask: Ask, { source, cuts, how }: Wanted, said: Said): Promise<Trial> {
  const base = { source, planarise: how, symmetry: null, cuts } as const;
  const { mesh } = await ask({ kind: "open", ...base }, "opened", told(said));
  return { how, instead: false, mesh, measures: await measured(ask), split: null };
}

async function splitting(
  ask: Ask,
  { source, cuts, how, split }: Wanted,
  said: Said,
): Promise<Trial> {
  await ask({ kind: "open", source, planarise: null, symmetry: null, cuts }, "opened");
  const question = { kind: "splitMesh", how, most: split } as const;
  const { mesh, panels, file } = await ask(question, "hybrid", told(said));
  return { how, instead: false, mesh, measures: await measured(ask), split: { panels, file } };
}

async function measured(ask: Ask) {
  const also = { fairness: null, folds: true, defectsOf: null };
  return (await ask({ kind: "panels", also }, "panels")).measures;
}
