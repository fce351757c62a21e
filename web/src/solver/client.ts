// SPDX-License-Identifier: MIT
import type { Reply, Request } from "./protocol.ts";

type Job = Exclude<Request, { kind: "start" }>;
/** Distributes over the union, unlike Omit. */
type Unnumbered<T> = T extends unknown ? Omit<T, "job"> : never;
export type Question = Unnumbered<Job>;
export type Progress = Extract<Reply, { kind: "progress" } | { kind: "reading" }>;
/** Said by the worker on its own. */
type Unasked = Extract<Reply, { kind: "ready" }>;
export type Answer = Exclude<Reply, Unasked | Progress>;

/** Rejects a job that was cancelled or overtaken; nothing to tell the user. */
export class Abandoned extends Error {}

/** Rejects the job that a solver died of; the new one knows nothing. */
export class Died extends Error {}

interface Waiting {
  readonly question: Question;
  readonly resolve: (answer: Answer) => void;
  readonly reject: (reason: Error) => void;
  /** Newest wins: a waiting question of the same stream is overtaken by the next one. */
  readonly stream: boolean;
}

/** A new worker; `died` is to be called when it is gone, whether it says so or not. */
export type SpawnWorker = (died: () => void) => Promise<Worker>;

export interface ClientEvents {
  readonly progress: (progress: Progress) => void;
  /** The worker is gone and its replacement starts: open and restore must follow. */
  readonly died: (sentence: string) => void;
}

const DIED = "The solver stopped unexpectedly. Your last finished design is back.";

/** Drives one solver worker: one job in flight, the others wait in order. */
export class SolverClient {
  readonly #spawn: SpawnWorker;
  readonly #events: ClientEvents;
  #worker: Worker | null = null;
  #starting: Promise<void>;
  #generation = 0;
  #job = 0;
  #current: Waiting | null = null;
  #queue: Waiting[] = [];

  constructor(spawn: SpawnWorker, events: ClientEvents) {
    this.#spawn = spawn;
    this.#events = events;
    this.#starting = this.#start();
  }

  /** Resolves when the worker can take jobs; rejects with a sentence for the user. */
  get ready(): Promise<void> {
    return this.#starting;
  }

  ask(question: Question): Promise<Answer> {
    return this.#enqueue(question, false);
  }

  /** Safe on every pointer move: a drag coalesces to its newest target, it never queues. */
  stream(question: Question): Promise<Answer> {
    this.dropStreams();
    return this.#enqueue(question, true);
  }

  /** Forgets frames that have not started: the drag has ended. */
  dropStreams(): void {
    const overtaken = this.#queue.filter((waiting) => waiting.stream);
    this.#queue = this.#queue.filter((waiting) => !waiting.stream);
    for (const waiting of overtaken) waiting.reject(new Abandoned());
  }

  /** Stops everything at once. The new worker knows nothing: open and restore must follow. */
  cancel(): void {
    this.#replace(new Abandoned());
  }

  #replace(reason: Error): void {
    this.#worker?.terminate();
    this.#worker = null;
    const running = this.#current;
    const waiting = this.#queue;
    this.#current = null;
    this.#queue = [];
    this.#starting = this.#start();
    // Whoever asks `ready` learns of a failure; nobody else has to.
    this.#starting.catch(() => {});
    running?.reject(reason);
    for (const { reject } of waiting) reject(new Abandoned());
  }

  #enqueue(question: Question, stream: boolean): Promise<Answer> {
    return new Promise((resolve, reject) => {
      this.#queue.push({ question, resolve, reject, stream });
      this.#next();
    });
  }

  async #start(): Promise<void> {
    this.#generation += 1;
    const generation = this.#generation;
    const gone = (): void => {
      if (generation === this.#generation && this.#worker) this.#die(DIED);
    };
    const worker = await this.#spawn(gone);
    if (generation !== this.#generation) {
      worker.terminate();
      return;
    }
    await new Promise<void>((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<Reply>) => {
        if (data.kind === "ready") resolve();
        else this.#receive(data);
      };
      worker.onerror = (event) => {
        event.preventDefault();
        reject(new Error(`The solver could not start: ${event.message}`));
        gone();
      };
    });
    if (generation !== this.#generation) return;
    this.#worker = worker;
    this.#next();
  }

  #next(): void {
    if (this.#current || !this.#worker) return;
    const next = this.#queue.shift();
    if (!next) return;
    this.#current = next;
    this.#worker.postMessage({ ...next.question, job: ++this.#job } as Request);
  }

  #receive(reply: Exclude<Reply, Unasked>): void {
    if (reply.job !== this.#job || !this.#current) return;
    if (reply.kind === "progress" || reply.kind === "reading") {
      this.#events.progress(reply);
      return;
    }
    if (reply.kind === "failed" && reply.fatal) {
      this.#die(reply.message);
      return;
    }
    const { resolve, reject } = this.#current;
    this.#current = null;
    if (reply.kind === "failed") reject(new Error(reply.message));
    else resolve(reply);
    this.#next();
  }

  #die(sentence: string): void {
    this.#replace(new Died(sentence));
    this.#events.died(sentence);
  }
}
