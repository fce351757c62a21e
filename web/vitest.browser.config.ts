// SPDX-License-Identifier: MIT
// Tests that need a browser: one browser and one server for all files, two files at a time, since a page
// keeps one core busy for most of its time.
import { availableParallelism } from "node:os";
import { fileURLToPath } from "node:url";
import { defineConfig, mergeConfig } from "vitest/config";
import base from "./vitest.config.ts";

export default mergeConfig(
  base,
  defineConfig({
    test: {
      dir: "tests/browser",
      globalSetup: ["tests/browser/support/server.ts"],
      setupFiles: [
        fileURLToPath(new URL("../tests/browser/support/each-file.ts", import.meta.url)),
      ],
      // What drives the browser is read once a process, not for each of fifty files.
      isolate: false,
      // Each time it asks three processes.
      expect: { poll: { interval: 100 } },
      fileParallelism: true,
      maxWorkers: Math.min(2, availableParallelism()),
    },
  }),
);
