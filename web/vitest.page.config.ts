// SPDX-License-Identifier: MIT
// The whole page without a browser: a DOM, the real core, a view that draws nothing.
import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";
import { defineConfig, mergeConfig } from "vitest/config";
import base from "./vitest.config.ts";

/** Modules of the core are read from their files: an address would be fetched. */
function wasmFiles(): Plugin {
  return {
    name: "wasm-files",
    enforce: "pre",
    async resolveId(id, importer) {
      if (!id.endsWith(".wasm?url")) return null;
      const found = await this.resolve(id.slice(0, -"?url".length), importer, { skipSelf: true });
      return found && `\0wasm-file:${found.id}.js`;
    },
    load(id) {
      const [, path] = /^\0wasm-file:(.*)\.js$/.exec(id) ?? [];
      return path ? `export default ${JSON.stringify(path)}` : null;
    },
  };
}

export default mergeConfig(
  base,
  defineConfig({
    plugins: [wasmFiles()],
    test: {
      dir: "tests/page",
      environment: fileURLToPath(new URL("../tests/page/support/environment.ts", import.meta.url)),
      setupFiles: [fileURLToPath(new URL("../tests/page/support/each-file.ts", import.meta.url))],
      // The page and the core are read and compiled once, not for each of forty files.
      isolate: false,
      expect: { poll: { interval: 5 } },
      fileParallelism: true,
    },
  }),
);
