// SPDX-License-Identifier: MIT
// The same edit by the command line and by the wasm core: 1e-9 relative, and the same points moved.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { PlanishModule } from "@wasm/planish.mjs";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { DEFAULT_SETTINGS } from "../../web/src/design/design.ts";
import { readObj } from "../browser/support/obj.ts";
import { loadPlanish } from "./support/planish.ts";

const CLI = new URL("../../build/native/planish", import.meta.url).pathname;
const RELATIVE = 1e-9;
const SAMPLES = ["vault", "dome", "freeform", "hex", "trihex"];
const RANDOM_EDITS = 10; // of each

let module: PlanishModule;
let folder: string;
beforeAll(async () => {
  module = await loadPlanish();
  folder = mkdtempSync(join(tmpdir(), "planish-parity-"));
});
afterAll(() => rmSync(folder, { recursive: true }));

/** Runs the command line and gives back the OBJ that it wrote. */
function runCli(...words: string[]): string {
  const out = join(folder, "out.obj");
  execFileSync(CLI, [...words, "-o", out]);
  return readFileSync(out, "utf8");
}

const text = (bytes: Uint8Array): string => new TextDecoder().decode(bytes);

/** Largest coordinate difference, relative to the size of the mesh. */
function deviation(a: string, b: string): number {
  const [left, right] = [readObj(a).points.flat(), readObj(b).points.flat()];
  expect(right.length).toBe(left.length);
  const size = Math.max(...left.map(Math.abs));
  return Math.max(...left.map((x, k) => Math.abs(x - (right[k] ?? Number.NaN)))) / size;
}

const differing = (a: string, b: string): number[] => {
  const [left, right] = [readObj(a).lines, readObj(b).lines];
  return left.flatMap((line, v) => (line === right[v] ? [] : [v]));
};

describe.each(SAMPLES)("%s", (name) => {
  const size = 17;

  it("is generated with the same bits", () => {
    const session = new module.Session();
    expect(session.openSample(name, size)).toBe("");
    expect(text(session.write("obj"))).toBe(runCli("sample", name, "--size", String(size)));
    session.delete();
  });

  it("is edited alike", () => {
    const session = new module.Session();
    session.openSample(name, size);
    const base = text(session.write("obj"));
    const vertex = Math.floor(session.basePositions().length / 6);
    const [x = 0, y = 0, z = 0] = session.basePositions().subarray(3 * vertex);
    const lifted = z + 0.5;
    expect(session.setOptions(DEFAULT_SETTINGS)).toBe("");
    const refusal = session.edit(
      module.EditMode.solve,
      Float64Array.of(vertex, x, y, lifted),
      new Int32Array(0),
      0,
      1,
    );
    expect(refusal).toBe("");
    const mesh = join(folder, "mesh.obj");
    execFileSync(CLI, ["sample", name, "--size", String(size), "-o", mesh]);
    const native = runCli("edit", mesh, "--handle", `${vertex}=${x},${y},${lifted}`);
    const wasm = text(session.write("obj"));
    expect(deviation(native, wasm)).toBeLessThan(RELATIVE);
    expect(differing(base, wasm)).toEqual(differing(base, native));
    session.delete();
  });
});

/** Numbers in [0, 1): the same in every run (Numerical Recipes' linear congruence). */
function numbers(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** Largest distance between a point of one file and the same point of another, in shares of `pull`. */
function distance(a: string, b: string, pull: number): number {
  const [left, right] = [readObj(a).points, readObj(b).points];
  expect(right.length).toBe(left.length);
  const apart = left.map((p, v) =>
    Math.hypot(...p.map((x, k) => x - (right[v]?.[k] ?? Number.NaN))),
  );
  return Math.max(...apart) / pull;
}

it.each(SAMPLES)("ten random edits of %s are the same", (name) => {
  const mesh = join(folder, `${name}.obj`);
  execFileSync(CLI, ["sample", name, "--size", "16", "-o", mesh]);
  const random = numbers(SAMPLES.indexOf(name) + 1);
  for (let edit = 0; edit < RANDOM_EDITS; ++edit) {
    const session = new module.Session();
    expect(session.openSample(name, 16)).toBe("");
    const base = session.basePositions();
    const vertex = Math.floor((random() * base.length) / 3);
    const pull = [0, 1, 2].map(() => 1.6 * random() - 0.8);
    const target = pull.map((x, k) => (base[3 * vertex + k] ?? 0) + x);
    expect(session.setOptions(DEFAULT_SETTINGS)).toBe("");
    const handle = Float64Array.of(vertex, ...target);
    expect(session.edit(module.EditMode.solve, handle, new Int32Array(0), 0, 1)).toBe("");
    const native = runCli("edit", mesh, "--handle", `${vertex}=${target.join(",")}`);
    const apart = distance(native, text(session.write("obj")), Math.hypot(...pull));
    session.delete();
    expect.soft(apart, `${name} ${vertex} by ${pull}`).toBeLessThan(RELATIVE);
  }
});
