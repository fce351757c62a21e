// SPDX-License-Identifier: MIT
// A browser costs ten times what a page without one does (tests/page): each file of tests/browser says in
// its head what it needs one for, and there are not too many tests.
import { readdirSync, readFileSync } from "node:fs";
import { expect, it } from "vitest";

const FOLDER = new URL("../browser/", import.meta.url);
const MOST = 90;

/** What a DOM in node has not; tests/browser/README.md says what each is. */
const NEEDS = [
  "axe",
  "focus",
  "frames",
  "layout",
  "network",
  "pixels",
  "pointer",
  "storage",
  "workers",
];

const files = readdirSync(FOLDER).filter((name) => name.endsWith(".test.ts"));
const read = (name: string): string => readFileSync(new URL(name, FOLDER), "utf8");

it.each(files)("%s says what it needs a browser for", (name) => {
  const [, words = ""] = /^\/\/ Needs: ([a-z, ]+)\.$/m.exec(read(name)) ?? [];
  expect(words.split(", ").filter((word) => !NEEDS.includes(word))).toEqual([]);
});

it(`there are at most ${MOST} tests with a browser`, () => {
  const count = (text: string): number =>
    text.match(/(?<![\w.])it(\.each|\.skipIf)?\(/g)?.length ?? 0;
  const all = files.map((name) => count(read(name))).reduce((sum, one) => sum + one, 0);
  expect(all).toBeLessThanOrEqual(MOST);
});
