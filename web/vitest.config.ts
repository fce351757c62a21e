// SPDX-License-Identifier: MIT
import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";
import { coreDefaults } from "./core-defaults.ts";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

const wasm = here("../build/wasm/wasm");

/** A machine for CI may be half as fast, and shared. */
const ci = Boolean(process.env["CI"]);

export default defineConfig({
  root: here(".."),
  resolve: { alias: { "@wasm": wasm } },
  plugins: [coreDefaults(wasm)],
  test: {
    include: ["**/*.test.ts"],
    // How long a test waits for the page; no figure of the product.
    expect: { poll: { timeout: ci ? 60_000 : 20_000 } },
    testTimeout: ci ? 360_000 : 180_000,
    hookTimeout: ci ? 120_000 : 60_000,
    // A wait that ran out there is waited for once more; the log names the test.
    retry: ci ? 1 : 0,
    fileParallelism: false,
  },
});
