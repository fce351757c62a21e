// SPDX-License-Identifier: MIT
import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";
import { PATIENCE, TEST_LIMIT } from "../tests/patience.ts";
import { coreDefaults } from "./core-defaults.ts";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

const wasm = here("../build/wasm/wasm");

export default defineConfig({
  root: here(".."),
  resolve: { alias: { "@wasm": wasm } },
  plugins: [coreDefaults(wasm)],
  test: {
    include: ["**/*.test.ts"],
    expect: { poll: { timeout: PATIENCE } },
    testTimeout: TEST_LIMIT,
    hookTimeout: TEST_LIMIT,
    fileParallelism: false,
  },
});
