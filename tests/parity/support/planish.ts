// SPDX-License-Identifier: MIT
import { readFile } from "node:fs/promises";
import type { PlanishModule } from "@wasm/planish.mjs";
import type { DocumentsModule } from "@wasm/planish_documents.mjs";

const BUILT = new URL("../../../build/wasm/wasm/", import.meta.url);

/** The wasm core in node, as the worker has it in the browser. */
export async function loadPlanish(): Promise<PlanishModule> {
  const { default: create } = await import(new URL("planish.mjs", BUILT).href);
  return create({ wasmBinary: await readFile(new URL("planish.wasm", BUILT)) });
}

/** The module that reads and writes documents, in node. */
export async function loadDocuments(): Promise<DocumentsModule> {
  const { default: create } = await import(new URL("planish_documents.mjs", BUILT).href);
  return create({ wasmBinary: await readFile(new URL("planish_documents.wasm", BUILT)) });
}
