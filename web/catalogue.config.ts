// SPDX-License-Identifier: MIT
// The page of a catalogue as plain files that the Python package carries: build/catalogue.
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  root: here("."),
  publicDir: false,
  define: { "process.env.NODE_ENV": JSON.stringify("production") },
  build: {
    outDir: here("../build/catalogue"),
    emptyOutDir: true,
    target: "es2022",
    lib: {
      entry: here("src/catalogue/main.tsx"),
      formats: ["iife"],
      name: "planishCataloguePage",
      fileName: () => "catalogue.js",
      cssFileName: "catalogue",
    },
  },
  oxc: { jsx: { runtime: "automatic", importSource: "preact" } },
});
