// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import { Abandoned, Died, SolverClient } from "../../web/src/solver/client.ts";
import type { Request } from "../../web/src/solver/protocol.ts";

const PANELS = {
  kind: "panels",
  also: { fairness: null, folds: false, defectsOf: null },
} as const;

/** A worker that answers only when told to. */
class SlowWorker {
  onmessage: ((event: { data: unknown }) => void) | null = null;
  onerror: ((event: unknown) => void) | null = null;
  readonly received: Request[] = [];
  terminated = false;
  /** Ends without a word, as when the browser kills it. */
  die: () => void = () => {};

  postMessage(request: Request): void {
    this.received.push(request);
  }

  terminate(): void {
    this.terminated = true;
  }

  reply(data: unknown): void {
    this.onmessage?.({ data });
  }
}

async function connect() {
  const workers: SlowWorker[] = [];
  const steps: number[] = [];
  const deaths: string[] = [];
  const spawn = async (died: () => void) => {
    const worker = new SlowWorker();
    worker.die = died;
    workers.push(worker);
    setTimeout(() => worker.reply({ kind: "ready", job: 0 }));
    return worker as unknown as Worker;
  };
  const client = new SolverClient(spawn, {
    progress: (progress) => steps.push(progress.kind === "progress" ? progress.step : 0),
    died: (sentence) => deaths.push(sentence),
  });
  await client.ready;
  const [worker] = workers;
  if (!worker) throw new Error("no worker");
  return { client, worker, workers, steps, deaths };
}

const settled = (promise: Promise<unknown>): Promise<unknown> => promise.catch((error) => error);

describe("the solver client", () => {
  it("has one job in flight and keeps only the newest frame waiting", async () => {
    const { client, worker } = await connect();
    const frames = [1, 2, 3].map((x) =>
      settled(client.stream({ kind: "vary", coefficients: [x] })),
    );
    expect(worker.received).toMatchObject([{ job: 1, coefficients: [1] }]);
    worker.reply({ kind: "exported", job: 1, bytes: new Uint8Array() });
    expect(worker.received).toMatchObject([{ job: 1 }, { job: 2, coefficients: [3] }]);
    worker.reply({ kind: "exported", job: 2, bytes: new Uint8Array() });
    const [first, second, third] = await Promise.all(frames);
    expect(first).toMatchObject({ job: 1 });
    expect(second).toBeInstanceOf(Abandoned);
    expect(third).toMatchObject({ job: 2 });
  });

  it("ignores answers to jobs that are gone, and reports progress", async () => {
    const { client, worker, steps } = await connect();
    const asked = client.ask({ kind: "exact" });
    worker.reply({ kind: "failed", job: 77, message: "stale", fatal: false });
    worker.reply({ kind: "progress", job: 1, step: 5, residual: 1 });
    worker.reply({ kind: "panels", job: 1, measures: null });
    expect(await asked).toMatchObject({ kind: "panels" });
    expect(steps).toEqual([5]);
  });

  it("turns a failure into its sentence and goes on", async () => {
    const { client, worker } = await connect();
    const asked = settled(client.ask({ kind: "exact" }));
    const next = client.ask(PANELS);
    worker.reply({ kind: "failed", job: 1, message: "No.", fatal: false });
    expect(await asked).toMatchObject({ message: "No." });
    worker.reply({ kind: "panels", job: 2, measures: null });
    expect(await next).toMatchObject({ kind: "panels" });
  });

  it("cancels by replacing the worker; later jobs go to the new one", async () => {
    const { client, worker, workers } = await connect();
    const asked = settled(client.ask({ kind: "exact" }));
    client.cancel();
    expect(await asked).toBeInstanceOf(Abandoned);
    expect(worker.terminated).toBe(true);
    const next = client.ask(PANELS);
    await client.ready;
    workers[1]?.reply({ kind: "panels", job: 2, measures: null });
    expect(await next).toMatchObject({ kind: "panels" });
  });

  it.each([
    ["without a word", (worker: SlowWorker) => worker.die()],
    [
      "with an error",
      (worker: SlowWorker) => worker.onerror?.({ preventDefault() {}, message: "" }),
    ],
    [
      "saying that it cannot go on",
      (worker: SlowWorker) =>
        worker.reply({ kind: "failed", job: 1, message: "It stopped.", fatal: true }),
    ],
  ])("replaces a worker that ends %s", async (_, end) => {
    const { client, worker, workers, deaths } = await connect();
    const asked = settled(client.ask({ kind: "exact" }));
    const waiting = settled(client.ask(PANELS));
    end(worker);
    expect(await asked).toBeInstanceOf(Died);
    expect(await waiting).toBeInstanceOf(Abandoned);
    expect(deaths).toEqual([expect.stringMatching(/stopped/)]);
    worker.die();
    expect(deaths.length).toBe(1);
    const next = client.ask(PANELS);
    await client.ready;
    workers[1]?.reply({ kind: "panels", job: 2, measures: null });
    expect(await next).toMatchObject({ kind: "panels" });
    expect(workers.length).toBe(2);
  });
});
