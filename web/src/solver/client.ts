// SPDX-License-Identifier: MIT
import type { Reply, Request } from "./protocol.ts";

type Job = Exclude<Request, { kind: "start" }>;
/** Distributes over the union, unlike Omit. */
type Unnumbered<T> = T extends unknown ? Omit<T, "job"> : never;
export type Question = Unnumbered<Job>;
export type Answer = Exclude<Reply, { kind: "ready" } | { kind: "progress" }>;

/** Rejects a job that was cancelled or overtaken; nothing to tell the user. */
export class Abandoned extends Error {}

interface Waiting {
  readonly question: Question;
  readonly resolve: (answer: Answer) => void;
  readonly reject: (reason: Error) => void;
  /** Newest wins: a waiting question of the same stream is overtaken by the next one. */
  readonly stream: boolean;
}

export type SpawnWorker = () => Promise<Worker>;

/** Drives one solver worker: one job in flight, the others wait in order. */
export class SolverClient {
  readonly #spawn: SpawnWorker;
  readonly #onProgress: (step: number, residual: number) => void;
  #worker: Worker | null = null;
  #starting: Promise<void>;
  #job = 0;
  #current: Waiting | null = null;
  #queue: Waiting[] = [];

  constructor(spawn: SpawnWorker, onProgress: (step: number, residual: number) => void) {
    this.#spawn = spawn;
    this.#onProgress = onProgress;
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
    this.#worker?.terminate();
    this.#worker = null;
    const abandoned = this.#current ? [this.#current, ...this.#queue] : this.#queue;
    this.#current = null;
    this.#queue = [];
    this.#starting = this.#start();
    for (const waiting of abandoned) waiting.reject(new Abandoned());
  }

  #enqueue(question: Question, stream: boolean): Promise<Answer> {
    return new Promise((resolve, reject) => {
      this.#queue.push({ question, resolve, reject, stream });
      this.#next();
    });
  }

  async #start(): Promise<void> {
    const worker = await this.#spawn();
    await new Promise<void>((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<Reply>) => {
        if (data.kind === "ready") resolve();
        else this.#receive(data);
      };
      worker.onerror = (event) => {
        event.preventDefault();
        reject(new Error(`The solver could not start: ${event.message}`));
        this.#crash();
      };
    });
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

  #receive(reply: Exclude<Reply, { kind: "ready" }>): void {
    if (reply.job !== this.#job || !this.#current) return;
    if (reply.kind === "progress") {
      this.#onProgress(reply.step, reply.residual);
      return;
    }
    const { resolve, reject } = this.#current;
    this.#current = null;
    if (reply.kind === "failed") reject(new Error(reply.message));
    else resolve(reply);
    this.#next();
  }

  #crash(): void {
    const waiting = this.#current;
    this.#current = null;
    waiting?.reject(new Error("The solver stopped unexpectedly; the design shown is kept."));
  }
}
