// SPDX-License-Identifier: MIT
import wasmUrl from "@wasm/planish.wasm?url";
import type { SpawnWorker } from "./client.ts";
import type { Request } from "./protocol.ts";
import { reachable } from "./reachable.ts";
import workerUrl from "./worker.ts?worker&url";

/** Compiles as it downloads; falls back where the server sends no wasm media type. */
async function compile(): Promise<WebAssembly.Module> {
  const response = await fetch(wasmUrl);
  if (!response.ok) throw new Error(`The solver could not be loaded (${response.status}).`);
  const streams = response.headers.get("content-type")?.startsWith("application/wasm");
  return streams
    ? WebAssembly.compileStreaming(response)
    : WebAssembly.compile(await response.arrayBuffer());
}

/**
 * A worker that is killed by the browser sends no event. The browser does release the lock that
 * the worker holds: whoever waits for it learns of the death. Without locks (a page that is not
 * served securely) only deaths with an error are noticed.
 */
function watch(worker: Worker, alive: string, died: () => void): void {
  if (!navigator.locks) return;
  worker.addEventListener("message", ({ data }: MessageEvent<{ kind: string }>) => {
    if (data.kind === "ready") navigator.locks.request(alive, died).catch(() => {});
  });
}

/** What starts solver workers; the module is compiled once for all of them. */
export function solverSpawner(): SpawnWorker {
  let compiled: Promise<WebAssembly.Module> | null = null;
  return (died) => {
    compiled ??= compile();
    return spawn(compiled, died);
  };
}

async function spawn(coming: Promise<WebAssembly.Module>, died: () => void): Promise<Worker> {
  // The worker loads its script while the module compiles.
  const worker = new Worker(reachable(workerUrl), { type: "module" });
  const compiled = await coming.catch((error: unknown) => {
    worker.terminate();
    throw error;
  });
  const alive = `planish-solver-${performance.timeOrigin}-${performance.now()}-${Math.random()}`;
  watch(worker, alive, died);
  worker.postMessage({ kind: "start", job: 0, compiled, alive } satisfies Request);
  return worker;
}
