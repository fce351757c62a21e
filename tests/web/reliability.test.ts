// SPDX-License-Identifier: MIT
// docs/reliability.md names a test for every promise: each is there, and in a folder whose check runs at every
// commit. That its cases show the promise is for readers.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { expect, it } from "vitest";

const PAGE = readFileSync("docs/reliability.md", "utf8");
const CHECKS = readFileSync(".tools/ci/checks.py", "utf8");

/** The check that runs a folder of tests; C++ tests in CMake's suites. */
const CHECK_OF: Readonly<Record<string, string>> = {
  browser: "browser",
  firefox: "firefox",
  fuzz: "fuzz",
  page: "page",
  parity: "parity",
  property: "native",
  regression: "sanitize",
  support: "native",
  unit: "sanitize",
  web: "unit",
};

const git = (...words: readonly string[]): string => execFileSync("git", words).toString();
const FILES = git("ls-files", "--cached", "--others", "--exclude-standard").split("\n");

/** Whether there is a file, or one in a folder; * stands for any part of a name. */
function isThere(path: string): boolean {
  const parts = path.split("*").map((part) => part.replace(/[.]/g, "\\."));
  const pattern = new RegExp(`^${parts.join("[^/]*")}(/|$)`);
  return FILES.some((file) => pattern.test(file));
}

const setOf = (name: string): readonly string[] =>
  JSON.parse(new RegExp(`^${name} = (\\[.*\\])$`, "m").exec(CHECKS)?.[1] ?? "[]");
const AT_COMMIT = [...setOf("BEFORE_SHOWING"), ...setOf("REST")];

const rowsBelow = (heading: string): readonly (readonly string[])[] =>
  (PAGE.split(`## ${heading}\n`)[1] ?? "")
    .split("\n## ")[0]
    ?.split("\n")
    .filter((line) => line.startsWith("| "))
    .slice(2)
    .map((line) => line.slice(2, -2).split(" | ")) ?? [];

/** Rows that are there at least: a heading that goes by another name would leave none to test. */
it.each([
  ["Promises and their tests", 20],
  ["Findings so far", 20],
] as const)("the page has the table of %s", (heading, least) => {
  expect(rowsBelow(heading).length).toBeGreaterThanOrEqual(least);
});

const checkFor = (path: string): string => CHECK_OF[path.split("/")[1] ?? ""] ?? "";

it.each(rowsBelow("Promises and their tests"))("%s", (_, where) => {
  const named = [...where.matchAll(/`(\.?t[a-z]+\/[^`]+|[a-z]+\/[^`]+)`/g)].map(
    ([, path]) => path ?? "",
  );
  for (const path of named) expect(isThere(path), path).toBe(true);
  const tests = named.filter((path) => path.startsWith("tests/"));
  for (const path of tests) expect(AT_COMMIT, path).toContain(checkFor(path));
  const checks = [...where.matchAll(/(?:check|preset) `(\w+)`|\.tools\/ci\/(cppcheck)/g)];
  for (const [, named1, named2] of checks) expect(AT_COMMIT).toContain(named1 ?? named2);
  expect(tests.length + checks.length + Number(/^same;/.test(where)), where).toBeGreaterThan(0);
});

const SOURCES = git("grep", "-hE", "^TEST(_F|_P)?\\(", "--", "tests");

it.each(rowsBelow("Findings so far"))("%s: %s", (_, __, where) => {
  const found = where.split(", ").map((word) => {
    const [folder, file] = word.replace(/^none of its own: /, "").split(": ");
    if (/^none: /.test(word)) return true;
    if (file)
      return ["_test.cpp", ".test.ts"].some((end) => isThere(`tests/${folder}/${file}${end}`));
    const [suite, name] = word.split(".");
    if (name) return SOURCES.includes(`(${suite}, ${name})`);
    return isThere(`tests/regression/${word}_test.cpp`);
  });
  expect(found, where).not.toContain(false);
});
