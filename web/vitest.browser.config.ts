// SPDX-License-Identifier: MIT
// Tests that need a browser: one browser and one server for all files, two files at a time, since a page
// keeps one core busy for most of its time.
import { availableParallelism } from "node:os";
import { defineConfig, mergeConfig } from "vitest/config";
import { NIGHTLY } from "../tests/patience.ts";
import base from "./vitest.config.ts";

/** Not run at every commit yet: these have not been run since pages are no
 * longer drawn. `npm run nightly` runs them; the list is to become empty. */
const OWED = [
  ...["groups", "growth", "guidance", "guide", "handles", "loops", "named-views", "offline"],
  ...["palette", "reach", "scrolling", "several", "supports", "transfer"],
];

export default mergeConfig(
  base,
  defineConfig({
    test: {
      dir: "tests/browser",
      exclude: NIGHTLY ? [] : OWED.map((name) => `**/${name}.test.ts`),
      globalSetup: ["tests/browser/support/server.ts"],
      fileParallelism: true,
      maxWorkers: Math.min(2, availableParallelism()),
    },
  }),
);
