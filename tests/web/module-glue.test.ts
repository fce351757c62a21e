// SPDX-License-Identifier: MIT
// One glue serves both modules of the page: the worker loads planish.mjs with the wasm of either.
import { readFileSync } from "node:fs";
import { expect, it } from "vitest";

const glue = (name: string): string =>
  readFileSync(new URL(`../../build/wasm/wasm/${name}.mjs`, import.meta.url), "utf8");

it("the glue of both modules is the same but for the name", () => {
  expect(glue("planish_whole").replaceAll("planish_whole", "planish")).toBe(glue("planish"));
});
