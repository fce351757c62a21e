// SPDX-License-Identifier: MIT
// For each file of tests: the places that it reaches (reached.config.mjs).
import { appendFileSync } from "node:fs";
import { relative } from "node:path";
import { afterAll, expect, inject } from "vitest";

const numbers = new Set();
globalThis.reached = (number) => numbers.add(number);

afterAll(() => {
  const file = relative(process.cwd(), expect.getState().testPath);
  appendFileSync(inject("reached"), [...numbers].map((number) => `${file} ${number}\n`).join(""));
});
