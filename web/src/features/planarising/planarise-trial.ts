// SPDX-License-Identifier: MIT
// What planarising would make of the opened mesh, computed beside the solver that holds it: nothing
// that it does changes the design, and it can be given up at any time.

import type { Trial } from "../../design/planarising.ts";
import type { SpawnWorker } from "../../solver/client.ts";
import type { Planarising, Reply, Request, Source } from "../../solver/protocol.ts";

/** Rejects a trial that another one took the place of, or that nobody waits for any more. */
export class GivenUp extends Error {}

const JOB = 1;

/** A worker of its own, which lives as long as trials follow each other. */
export class PlanariseTrials {
  readonly #spawn: SpawnWorker;
  #worker: Promise<Worker> | null = null;
  /** Rejects what runs. */
  #giveUp: (() => void) | null = null;

  constructor(spawn: SpawnWorker) {
    this.#spawn = spawn;
  }

  /** The newest wins. @throws GivenUp, or an Error with the sentence of the refusal */
  async run(source: Source, cuts: readonly string[], how: Planarising): Promise<Trial> {
    if (this.#giveUp) this.end();
    const given = new Promise<never>((_, reject) => {
      this.#giveUp = () => reject(new GivenUp());
    });
    const mine = this.#giveUp;
    try {
      return await Promise.race([given, this.#compute(source, cuts, how)]);
    } finally {
      if (this.#giveUp === mine) this.#giveUp = null;
    }
  }

  /** Gives up what runs and lets the worker go. */
  end(): void {
    this.#worker?.then(
      (worker) => worker.terminate(),
      () => {},
    );
    this.#worker = null;
    this.#giveUp?.();
    this.#giveUp = null;
  }

  async #compute(source: Source, cuts: readonly string[], how: Planarising): Promise<Trial> {
    this.#worker ??= startWorker(this.#spawn);
    const worker = await this.#worker;
    const base = { source, planarise: how, symmetry: null, cuts } as const;
    const { mesh } = await ask(worker, { kind: "open", job: JOB, ...base }, "opened");
    const also = { fairness: null, folds: true, defectsOf: null };
    const question = { kind: "panels", job: JOB, also } as const;
    return { how, mesh, measures: (await ask(worker, question, "panels")).measures };
  }
}

async function startWorker(spawn: SpawnWorker): Promise<Worker> {
  const worker = await spawn(() => {});
  await heard(worker, "ready");
  return worker;
}

type ReplyOf<K extends Reply["kind"]> = Extract<Reply, { kind: K }>;

/** The next reply of a kind; a refusal rejects. */
function heard<K extends Reply["kind"]>(worker: Worker, kind: K): Promise<ReplyOf<K>> {
  return new Promise((resolve, reject) => {
    const off = new AbortController();
    const listen = ({ data }: MessageEvent<Reply>): void => {
      if (data.kind === kind) resolve(data as ReplyOf<K>);
      else if (data.kind === "failed") reject(new Error(data.message));
      else return;
      off.abort();
    };
    worker.addEventListener("message", listen, { signal: off.signal });
    worker.addEventListener(
      "error",
      (event) => {
        event.preventDefault();
        reject(new Error("The preview stopped unexpectedly."));
        off.abort();
      },
      { signal: off.signal },
    );
  });
}

function ask<K extends Reply["kind"]>(
  worker: Worker,
  request: Request,
  kind: K,
): Promise<ReplyOf<K>> {
  const answer = heard(worker, kind);
  worker.postMessage(request);
  return answer;
}
