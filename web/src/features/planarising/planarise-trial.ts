// SPDX-License-Identifier: MIT
// What planarising would make of the opened mesh, computed beside the solver that holds it.

import type { Trial } from "../../design/planarising.ts";
import type { SpawnWorker } from "../../solver/client.ts";
import type { Planarising, Source } from "../../solver/protocol.ts";
import { type Ask, SecondSolver } from "../../solver/second-solver.ts";

/** Of which mesh, and how. */
interface Wanted {
  readonly source: Source;
  readonly cuts: readonly string[];
  readonly how: Planarising;
  /** So many panels may be split for it; 0: none. */
  readonly split: number;
}

export class PlanariseTrials {
  readonly #solver: SecondSolver;

  constructor(spawn: SpawnWorker) {
    this.#solver = new SecondSolver(spawn);
  }

  /** The newest wins. @throws GivenUp, or an Error with the sentence of the refusal */
  run(wanted: Wanted): Promise<Trial> {
    return this.#solver.run((ask) =>
      wanted.split > 0 ? splitting(ask, wanted) : whole(ask, wanted),
    );
  }

  /** Gives up what runs and lets the worker go. */
  end(): void {
    this.#solver.end();
  }
}

async function whole(ask: Ask, { source, cuts, how }: Wanted): Promise<Trial> {
  const base = { source, planarise: how, symmetry: null, cuts } as const;
  const { mesh } = await ask({ kind: "open", ...base }, "opened");
  return { how, mesh, measures: await measured(ask), split: null };
}

async function splitting(ask: Ask, { source, cuts, how, split }: Wanted): Promise<Trial> {
  await ask({ kind: "open", source, planarise: null, symmetry: null, cuts }, "opened");
  const { mesh, panels, file } = await ask({ kind: "splitMesh", how, most: split }, "hybrid");
  return { how, mesh, measures: await measured(ask), split: { panels, file } };
}

async function measured(ask: Ask) {
  const also = { fairness: null, folds: true, defectsOf: null };
  return (await ask({ kind: "panels", also }, "panels")).measures;
}
