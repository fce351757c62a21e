// SPDX-License-Identifier: MIT
// A solver beside the one that holds the design: what it tries out changes nothing, and can be given up
// at any time.

import type { SpawnWorker } from "./client.ts";
import type { Reply, Request } from "./protocol.ts";

/** Rejects what something newer took the place of, or that nobody waits for any more. */
export class GivenUp extends Error {}

/** Of the requests one after the other; what is awaited is always the last. */
const JOB = 1;

type ReplyOf<K extends Reply["kind"]> = Extract<Reply, { kind: K }>;
/** Distributes over the union, unlike Omit. */
type Unnumbered<T> = T extends unknown ? Omit<T, "job"> : never;

/** What is told before the reply. */
export type News = ReplyOf<"progress" | "standing">;

/** Asks and waits for the reply of a kind; a refusal rejects with its sentence. */
export type Ask = <K extends Reply["kind"]>(
  question: Unnumbered<Exclude<Request, { kind: "start" }>>,
  kind: K,
  onNews?: (news: News) => void,
) => Promise<ReplyOf<K>>;

/** A worker of its own, which lives as long as questions follow each other. */
export class SecondSolver {
  readonly #spawn: SpawnWorker;
  #worker: Promise<Worker> | null = null;
  /** Rejects what runs. */
  #giveUp: (() => void) | null = null;

  constructor(spawn: SpawnWorker) {
    this.#spawn = spawn;
  }

  /** The newest wins. @throws GivenUp, or an Error with the sentence of the refusal */
  async run<T>(work: (ask: Ask) => Promise<T>): Promise<T> {
    if (this.#giveUp) this.end();
    const given = new Promise<never>((_, reject) => {
      this.#giveUp = () => reject(new GivenUp());
    });
    const mine = this.#giveUp;
    try {
      return await Promise.race([given, this.#begin(work)]);
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

  async #begin<T>(work: (ask: Ask) => Promise<T>): Promise<T> {
    this.#worker ??= startWorker(this.#spawn);
    const worker = await this.#worker;
    return work((question, kind, onNews = () => {}) => {
      const answer = heard(worker, kind, onNews);
      worker.postMessage({ ...question, job: JOB } as Request);
      return answer;
    });
  }
}

async function startWorker(spawn: SpawnWorker): Promise<Worker> {
  const worker = await spawn(() => {});
  await heard(worker, "ready", () => {});
  return worker;
}

/** The next reply of a kind; a refusal rejects. */
function heard<K extends Reply["kind"]>(
  worker: Worker,
  kind: K,
  onNews: (news: News) => void,
): Promise<ReplyOf<K>> {
  return new Promise((resolve, reject) => {
    const off = new AbortController();
    const listen = ({ data }: MessageEvent<Reply>): void => {
      if (data.kind === "progress" || data.kind === "standing") onNews(data);
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
