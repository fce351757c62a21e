// SPDX-License-Identifier: MIT
// A page without a browser: its solver is the wasm core in node, behind the worker's own dispatcher.
import type { PlanishModule } from "@wasm/planish.mjs";
import type { SpawnWorker } from "../../../web/src/solver/client.ts";
import { Dispatcher } from "../../../web/src/solver/dispatch.ts";
import type { Reply, Request } from "../../../web/src/solver/protocol.ts";
import { openSample } from "../../../web/src/state/opening.ts";
import { Page } from "../../../web/src/state/page.ts";
import { recoverFromDeath } from "../../../web/src/state/showing.ts";
import { loadPlanish } from "../../parity/support/planish.ts";

type Job = Exclude<Request, { kind: "start" }>;

/** What happens to requests: null lets the core answer; of several the last may be missing. */
export type Fate = (request: Job) => Reply | readonly Reply[] | null;

/** What every object of the core has. */
interface Made {
  isDeleted(): boolean;
  delete(): void;
}

/** The core as one worker has it: what that makes is freed with it, as with a worker that ends. */
function owned(module: PlanishModule): { readonly own: PlanishModule; readonly free: () => void } {
  const made: Made[] = [];
  const noted = <T extends new (...given: never[]) => object>(kind: T): T =>
    new Proxy(kind, {
      construct(target, given: never[]) {
        const one = new target(...given);
        made.push(one as Made);
        return one;
      },
    });
  const { Session, Analysis } = module;
  const own = Object.create(module, {
    Session: { value: noted(Session) },
    Analysis: { value: noted(Analysis) },
  });
  const free = (): void => {
    for (const one of made.splice(0)) if (!one.isDeleted()) one.delete();
  };
  return { own, free };
}

/** As much of a Worker as the page uses. Answers come later, in order, as messages do. */
class WorkerHere extends EventTarget {
  onmessage: ((event: MessageEvent<Reply>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  readonly #dispatcher: Dispatcher;
  readonly #fate: Fate;
  readonly #free: () => void;
  #gone = false;
  #working: Promise<void> = Promise.resolve();

  constructor(module: PlanishModule, fate: Fate) {
    super();
    this.#fate = fate;
    const { own, free } = owned(module);
    this.#free = free;
    this.#dispatcher = new Dispatcher(own, (reply) => this.#say(reply));
    this.#say({ kind: "ready", job: 0 });
  }

  postMessage(request: Job): void {
    this.#working = this.#working.then(async () => {
      await new Promise((resolve) => setTimeout(resolve));
      if (this.#gone) return;
      const fate = this.#fate(request);
      if (fate) for (const reply of [fate].flat()) this.#say(reply);
      else await this.#dispatcher.handle(request);
    });
  }

  terminate(): void {
    this.#gone = true;
    void this.#working.then(this.#free, this.#free);
  }

  #say(data: Reply): void {
    setTimeout(() => {
      if (this.#gone) return;
      const event = new MessageEvent<Reply>("message", { data });
      this.onmessage?.(event);
      this.dispatchEvent(event);
    });
  }
}

/** Loaded once for all pages of a test file. */
let loaded: Promise<PlanishModule> | null = null;

function spawnHere(fate: Fate, all: WorkerHere[]): SpawnWorker {
  return async () => {
    loaded ??= loadPlanish();
    const worker = new WorkerHere(await loaded, fate);
    all.push(worker);
    return worker as unknown as Worker;
  };
}

const workers = new WeakMap<Page, WorkerHere[]>();

/** A page that is left ends its workers. */
export function endWorkers(page: Page): void {
  for (const worker of workers.get(page)?.splice(0) ?? []) worker.terminate();
}

/** One with nothing open yet. */
export function pageHere(fate: Fate = () => null): Page {
  const all: WorkerHere[] = [];
  const page = new Page(spawnHere(fate, all));
  workers.set(page, all);
  recoverFromDeath(page);
  page.ready.value = true;
  return page;
}

/** One whose solver never comes. */
export const pageAlone = (): Page => {
  const never = <T>() => new Promise<T>(() => {});
  return new Page(() => never<Worker>());
};

/** One with a sample open. */
export async function openedPage(sample = "roof", fate?: Fate): Promise<Page> {
  const page = pageHere(fate);
  await openSample(page, sample);
  return page;
}
