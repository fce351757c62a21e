// SPDX-License-Identifier: MIT
// The worker's entry: loads the module, then hands every request to the dispatcher.
import createPlanish, { type PlanishModule } from "@wasm/planish.mjs";
import { Dispatcher } from "./dispatch.ts";
import type { Reply, Request } from "./protocol.ts";
import { warmUp } from "./warm-up.ts";

const scope = self as unknown as DedicatedWorkerGlobalScope;
const post = (reply: Reply, transfer: Transferable[]): void => scope.postMessage(reply, transfer);

interface Solver {
  readonly planish: PlanishModule;
  readonly dispatcher: Dispatcher;
}

let solver: Promise<Solver> | null = null;
let warm = false;

/** Holds a lock until the worker ends, however it ends. */
function stayAlive(name: string): Promise<void> {
  return new Promise((resolve) => {
    if (!scope.navigator.locks) resolve();
    const hold = () => {
      resolve();
      return new Promise<void>(() => {});
    };
    scope.navigator.locks?.request(name, hold).catch(() => resolve());
  });
}

/** The page compiles once; a worker that replaces a cancelled one starts from the same module. */
async function start(compiled: WebAssembly.Module, alive: string): Promise<Solver> {
  const [planish] = await Promise.all([
    createPlanish({
      instantiateWasm(
        imports: WebAssembly.Imports,
        done: (instance: WebAssembly.Instance) => void,
      ) {
        WebAssembly.instantiate(compiled, imports).then(done);
        return {};
      },
    }),
    stayAlive(alive),
  ]);
  post({ kind: "ready", job: 0 }, []);
  return { planish, dispatcher: new Dispatcher(planish, post) };
}

scope.onmessage = async ({ data }: MessageEvent<Request>): Promise<void> => {
  if (data.kind === "start") {
    solver = start(data.compiled, data.alive);
    // Thrown, the page hears of it as an error of the worker.
    solver.catch((error: unknown) => {
      setTimeout(() => {
        throw error;
      });
    });
    return;
  }
  const started = await solver;
  await started?.dispatcher.handle(data);
  if (!started || warm) return;
  // Warms up after the first mesh is open, when there is time.
  warm = true;
  await warmUp(started.planish).catch(() => {});
};
