// SPDX-License-Identifier: MIT
// What the core holds where nobody says otherwise, asked when the page is built: defaults and words are
// written nowhere else. Their types are those of wasm/planish_designs.d.ts.
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import type { Plugin } from "vite";
import type createDocuments from "../wasm/planish_documents.d.ts";

const ID = "virtual:core-defaults";

type Import = (url: string) => Promise<unknown>;

async function askCore(wasmDir: string, load: Import): Promise<string> {
  const glue = pathToFileURL(join(wasmDir, "planish_documents.mjs")).href;
  const create = ((await load(glue)) as { default: typeof createDocuments }).default;
  const wasmBinary = await readFile(join(wasmDir, "planish_documents.wasm"));
  const { options, ...others } = (await create({ wasmBinary })).defaults();
  const usual = Object.fromEntries(options.map((row) => [row.key, row.usual]));
  const words = Object.fromEntries(
    options.flatMap(({ key, words }) => (words ? [[key, words]] : [])),
  );
  const constants = { usual, words, ...others };
  return Object.entries(constants)
    .map(([name, value]) => `export const ${name} = ${JSON.stringify(value)};`)
    .join("\n");
}

/** @param load imports the core's glue: whoever ran this file through Vite's runner, which is closed
 * by then, gives an import of its own */
export function coreDefaults(
  wasmDir: string,
  load: Import = (url) => import(/* @vite-ignore */ url),
): Plugin {
  return {
    name: "core-defaults",
    resolveId: (id) => (id === ID ? `\0${ID}` : null),
    load: (id) => (id === `\0${ID}` ? askCore(wasmDir, load) : null),
  };
}
