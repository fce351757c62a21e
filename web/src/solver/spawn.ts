// SPDX-License-Identifier: MIT
import wasmUrl from "@wasm/planish.wasm?url";
import type { Request } from "./protocol.ts";

let compiled: Promise<WebAssembly.Module> | null = null;

/** Compiles as it downloads; falls back where the server sends no wasm media type. */
async function compile(): Promise<WebAssembly.Module> {
  const response = await fetch(wasmUrl);
  if (!response.ok) throw new Error(`The solver could not be loaded (${response.status}).`);
  if (response.headers.get("content-type")?.startsWith("application/wasm")) {
    return WebAssembly.compileStreaming(response);
  }
  return WebAssembly.compile(await response.arrayBuffer());
}

/** A new solver worker; the module is compiled once for the life of the page. */
export async function spawnSolver(): Promise<Worker> {
  compiled ??= compile();
  const module = await compiled;
  const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
  worker.postMessage({ kind: "start", job: 0, module } satisfies Request);
  return worker;
}
