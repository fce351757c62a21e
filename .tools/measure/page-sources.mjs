// SPDX-License-Identifier: MIT
// The page's own sources and its core, for measures that need no page.
import { readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { createServer, runnerImport } from "vite";

const WASM = resolve("build/wasm/wasm");

/** The modules of the page called `names`, from "/web/src/…". */
export async function loadSources(names) {
  const { module } = await runnerImport(resolve("web/core-defaults.ts"));
  const server = await createServer({
    root: process.cwd(),
    configFile: false,
    logLevel: "error",
    resolve: { alias: { "@wasm": WASM } },
    plugins: [module.coreDefaults(`${WASM}/`, (url) => import(url))],
    server: { middlewareMode: true, watch: null },
    optimizeDeps: { noDiscovery: true },
  });
  try {
    return await Promise.all(names.map((name) => server.ssrLoadModule(name)));
  } finally {
    await server.close();
  }
}

export async function loadCore() {
  const { default: create } = await import(pathToFileURL(join(WASM, "planish.mjs")).href);
  return create({ wasmBinary: readFileSync(join(WASM, "planish.wasm")) });
}
