// SPDX-License-Identifier: MIT
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { partOfControls } from "./chunks.ts";
import { coreDefaults } from "./core-defaults.ts";
import { firstMesh } from "./first-mesh.ts";
import { smallFont } from "./font.ts";
import { guide } from "./guide.ts";
import { noCodeFromText } from "./no-code-from-text.ts";
import { offline } from "./offline.ts";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));
const wasm = process.env.PLANISH_WASM_DIR ?? here("../build/wasm/wasm");

export default defineConfig({
  root: here("."),
  base: "./",
  publicDir: here("public"),
  resolve: { alias: { "@wasm": wasm } },
  server: { fs: { allow: [here(".."), wasm] } },
  plugins: [coreDefaults(wasm), firstMesh(wasm), smallFont(), guide(), offline()],
  worker: { format: "es", plugins: () => [coreDefaults(wasm), noCodeFromText()] },
  build: {
    outDir: here("../dist"),
    emptyOutDir: true,
    target: "es2022",
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 1200,
    rolldownOptions: {
      output: {
        codeSplitting: {
          // What two parts share stays apart: a drag needs some of it.
          includeDependenciesRecursively: false,
          groups: [
            { name: "page", tags: ["$initial"] },
            { name: partOfControls, debugName: "controls" },
          ],
        },
      },
    },
  },
});
