// SPDX-License-Identifier: MIT
// The README's examples of the command line: each does something that a designer keeps.
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { afterAll, describe, expect, it } from "vitest";
import { readObj, sharpestFold } from "../browser/support/obj.ts";

const COMMAND = resolve("build/native/planish");
const folder = mkdtempSync(join(tmpdir(), "planish-readme-"));
afterAll(() => rmSync(folder, { recursive: true, force: true }));

const EXAMPLES = readFileSync("README.md", "utf8")
  .split("\n")
  .filter((line) => line.startsWith("    planish "))
  .map((line) => line.trim());

interface Report {
  readonly status: string;
  readonly moved_vertices: number;
  readonly handle_error: number;
  /** None of what only makes panels flat or alike. */
  readonly sharpest_fold?: { readonly after: number };
}

/** The mesh "that you bring": a vault whose points were written with two decimals. */
function bringMesh(): void {
  const vault = execFileSync(COMMAND, ["sample", "vault", "--size", "20", "-o", "-"]).toString();
  const rounded = vault.replace(/-?\d+\.\d+(e-?\d+)?/g, (number) => Number(number).toFixed(2));
  writeFileSync(join(folder, "imported.obj"), rounded);
}

/** How far the handle of an example is to go. */
const way = (words: readonly string[]): number =>
  Math.hypot(
    ...(words[words.indexOf("--handle") + 1]?.split("=")[1]?.split(",") ?? []).map(Number),
  );

/** Runs it where those before it ran. */
function run(line: string, more: readonly string[] = []): Report | null {
  const words = line.split(" ").slice(1);
  const { status, stderr } = spawnSync(COMMAND, [...words, ...more], { cwd: folder });
  expect(status, `${line}\n${stderr}`).toBe(0);
  return more.length > 0 ? JSON.parse(readFileSync(join(folder, "report.json"), "utf8")) : null;
}

const foldIn = (file = ""): number =>
  sharpestFold(readObj(readFileSync(join(folder, file), "utf8")));

describe("the README's examples of the command line, in their order", () => {
  bringMesh();

  it.each(EXAMPLES)("%s", (line) => {
    const words = line.split(" ");
    const moves = /^planish (edit|explore|project|replay) /.test(line);
    const report = run(line, moves ? ["--report", "report.json"] : []);
    if (!report) return;
    expect(report.moved_vertices).toBeGreaterThan(0);
    expect(report.sharpest_fold?.after ?? foldIn(words.at(-1))).toBeLessThan(25);
    const few = words.includes("--fewest"); // which are the fewest nobody certifies
    if (!few) expect(report.status).toBe("converged");
    const goes = words.includes("--handle") && words[1] === "edit";
    if (goes) expect(report.handle_error).toBeLessThanOrEqual(0.05 * way(words));
  });
});

it("shows what each example gives in docs/examples.md, in their order", () => {
  const [, ...parts] = readFileSync("docs/examples.md", "utf8").split(/^ {4}(?=planish )/m);
  expect(parts.map((part) => part.split("\n")[0])).toEqual(EXAMPLES);
  for (const part of parts) {
    const [, picture] = /\]\((pictures\/[^)]+)\)/.exec(part) ?? [];
    if (/^planish (info|compare) /.test(part)) expect(picture).toBeUndefined();
    else expect(existsSync(join("docs", picture ?? "")) && picture, part).toBeTruthy();
  }
});
