// SPDX-License-Identifier: MIT
// The built `planish` command and the built test program, with their reports as objects.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

export const ROOT = new URL("../../", import.meta.url).pathname;
const PLANISH = join(ROOT, "build/native/planish");
const TESTS = join(ROOT, "build/native/tests/planish_tests");
/** Standard output of a mesh with a few thousand vertices, with room to spare. */
const LARGEST = 64 * 1024 * 1024;

/** Tests run whole sets, as at night. */
const env = { ...process.env, PLANISH_NIGHTLY: "1" };

const run = (program, words) =>
  execFileSync(program, words, { encoding: "utf8", maxBuffer: LARGEST, env });

/** Runs `use` with an empty directory that is gone afterwards. */
function withDirectory(use) {
  const directory = mkdtempSync(join(tmpdir(), "planish-paper-"));
  try {
    return use(directory);
  } finally {
    rmSync(directory, { recursive: true });
  }
}

/** What `planish` writes to standard output. */
export const planish = (...words) => run(PLANISH, words);

/** The report of a command. */
export const report = (...words) => JSON.parse(planish(...words, "--report", "-"));

/** The report of a command, and the design that it records. */
export function design(...words) {
  return withDirectory((directory) => {
    const file = join(directory, "design.json");
    const figures = report(...words, "--design", file);
    return { figures, design: JSON.parse(readFileSync(file, "utf8")) };
  });
}

/** What the tests of `filter` recorded: test name → { outcome, key: value… }. */
export function recordedClaims(filter) {
  return withDirectory((directory) => {
    const file = join(directory, "claims.json");
    let failed = false;
    try {
      run(TESTS, [`--gtest_filter=${filter}`, `--gtest_output=json:${file}`]);
    } catch {
      failed = true;
    }
    const suites = JSON.parse(readFileSync(file, "utf8")).testsuites;
    const tests = suites.flatMap((suite) => suite.testsuite);
    if (failed) console.error(`paper: a claim does not hold; see ${filter}`);
    return Object.fromEntries(
      tests.map(({ name, failures, ...rest }) => [
        name,
        { ...rest, holds: (failures ?? []).length === 0 },
      ]),
    );
  });
}
