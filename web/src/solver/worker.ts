// SPDX-License-Identifier: MIT
// The worker's entry: loads the module, then hands every request to the dispatcher.
import createPlanish from "@wasm/planish.mjs";
import { Dispatcher } from "./dispatch.ts";
import type { Reply, Request } from "./protocol.ts";

const scope = self as unknown as DedicatedWorkerGlobalScope;
const post = (reply: Reply, transfer: Transferable[]): void => scope.postMessage(reply, transfer);

let dispatcher: Promise<Dispatcher> | null = null;

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
async function start(compiled: WebAssembly.Module, alive: string): Promise<Dispatcher> {
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
  return new Dispatcher(planish, post);
}

scope.onmessage = async ({ data }: MessageEvent<Request>): Promise<void> => {
  if (data.kind === "start") {
    dispatcher = start(data.module, data.alive);
    return;
  }
  await (await dispatcher)?.handle(data);
};
