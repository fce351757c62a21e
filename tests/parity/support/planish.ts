// SPDX-License-Identifier: MIT
import { readFile } from "node:fs/promises";
import type { PlanishModule } from "@wasm/planish.mjs";

const BUILT = new URL("../../../build/wasm/wasm/", import.meta.url);

/** The wasm core in node, as the worker has it in the browser. */
export async function loadPlanish(): Promise<PlanishModule> {
  const { default: create } = await import(new URL("planish.mjs", BUILT).href);
  return create({ wasmBinary: await readFile(new URL("planish.wasm", BUILT)) });
}
