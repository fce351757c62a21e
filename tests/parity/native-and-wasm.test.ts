// SPDX-License-Identifier: MIT
// The same edit by the command line and by the wasm core: 1e-9 relative, and the same points moved.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { PlanishModule } from "@wasm/planish.mjs";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { readObj } from "../browser/support/obj.ts";
import { loadPlanish } from "./support/planish.ts";

const CLI = new URL("../../build/native/planish", import.meta.url).pathname;
const RELATIVE = 1e-9;

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

const defaults = () => ({
  attraction: 1000,
  locality: 1,
  smoothness: 1,
  fairness: module.FairnessKind.second,
  sparsity: module.Sparsity.l21,
  hardHandles: false,
  keepShape: true,
  engine: module.Engine.newton,
  tolerance: 1e-6,
  maxIterations: 0,
  reach: 0,
  reachLength: 0,
  keepBoundary: false,
  softness: 0,
});

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

describe.each(["vault", "dome", "freeform", "hex", "trihex"])("%s", (name) => {
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
    expect(session.setOptions(defaults())).toBe("");
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
