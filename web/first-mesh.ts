// SPDX-License-Identifier: MIT
// The mesh that paints before the solver is ready: the first sample, made at build time by the
// same core, as display coordinates and faces.
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import type { Plugin } from "vite";
import type createPlanish from "../wasm/planish.d.ts";
import { FIRST_SAMPLE } from "./src/design/samples.ts";

const ID = "virtual:first-mesh";

async function makeFirstMesh(wasmDir: string): Promise<string> {
  const glue = pathToFileURL(join(wasmDir, "planish.mjs")).href;
  const create = ((await import(glue)) as { default: typeof createPlanish }).default;
  const wasmBinary = await readFile(join(wasmDir, "planish.wasm"));
  const session = new (await create({ wasmBinary })).Session();
  const refusal = session.openSample(FIRST_SAMPLE.name, FIRST_SAMPLE.size);
  if (refusal) throw new Error(refusal);
  const mesh = {
    positions: Array.from(session.displayBase(), (x) => Number(x.toFixed(4))),
    offsets: Array.from(session.faceOffsets()),
    vertices: Array.from(session.faceVertices()),
  };
  session.delete();
  return `export default ${JSON.stringify(mesh)};`;
}

export function firstMesh(wasmDir: string): Plugin {
  return {
    name: "first-mesh",
    resolveId: (id) => (id === ID ? `\0${ID}` : null),
    load: (id) => (id === `\0${ID}` ? makeFirstMesh(wasmDir) : null),
  };
}
