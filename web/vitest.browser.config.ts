// SPDX-License-Identifier: MIT
// Tests that need a browser: one browser and one server for all files, two files at a time, since a page
// keeps one core busy for most of its time.
import { availableParallelism } from "node:os";
import { defineConfig, mergeConfig } from "vitest/config";
import base from "./vitest.config.ts";

export default mergeConfig(
  base,
  defineConfig({
    test: {
      dir: "tests/browser",
      globalSetup: ["tests/browser/support/server.ts"],
      fileParallelism: true,
      maxWorkers: Math.min(2, availableParallelism()),
    },
  }),
);
