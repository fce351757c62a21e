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

/** As much of a Worker as the page uses. Answers come later, in order, as messages do. */
class WorkerHere extends EventTarget {
  onmessage: ((event: MessageEvent<Reply>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  readonly #dispatcher: Dispatcher;
  readonly #fate: Fate;
  #gone = false;
  #working: Promise<void> = Promise.resolve();

  constructor(module: PlanishModule, fate: Fate) {
    super();
    this.#fate = fate;
    this.#dispatcher = new Dispatcher(module, (reply) => this.#say(reply));
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

function spawnHere(fate: Fate): SpawnWorker {
  return async () => {
    loaded ??= loadPlanish();
    return new WorkerHere(await loaded, fate) as unknown as Worker;
  };
}

/** One with nothing open yet. */
export function pageHere(fate: Fate = () => null): Page {
  const page = new Page(spawnHere(fate));
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
