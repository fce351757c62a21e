// SPDX-License-Identifier: MIT
// A mesh in a second solver, by the page's own dispatcher: where its flat points are known nothing is solved
// again, and it is the same to the bit.
import type { PlanishModule } from "@wasm/planish.mjs";
import { beforeAll, expect, it } from "vitest";
import type { OpenedMesh, Planarising } from "../../web/src/solver/protocol.ts";
import { keepCopy } from "../../web/src/solver/reading.ts";
import { type Base, openKnownQuestion, openQuestion } from "../../web/src/state/connection.ts";
import { loadPlanish } from "./support/planish.ts";
import { SolverHere } from "./support/solver-here.ts";

let module: PlanishModule;
beforeAll(async () => {
  module = await loadPlanish();
});

const SIDE = 5;

/** Quads that are not flat, the same on both sides of x = 2. */
function bentFile(): Uint8Array<ArrayBuffer> {
  const places = Array.from({ length: SIDE * SIDE }, (_, v) => [v % SIDE, Math.floor(v / SIDE)]);
  const points = places.map(([x = 0, y = 0]) => `v ${x} ${y} ${0.1 * (x - 2) ** 2 * y}`);
  const panels = places.flatMap(([x = 0, y = 0], v) =>
    x + 1 < SIDE && y + 1 < SIDE ? [`f ${v + 1} ${v + 2} ${v + SIDE + 2} ${v + SIDE + 1}`] : [],
  );
  return new TextEncoder().encode([...points, ...panels].join("\n"));
}

const NEAREST: Planarising = {
  smooth: 0,
  keepBoundary: false,
  keepShape: true,
  within: 0,
  flat: 0,
  constraints: [],
};

/** The mesh, and in how many steps of a solver it came. */
async function opened(
  question: ReturnType<typeof openQuestion> & { found?: Float64Array },
): Promise<{ mesh: OpenedMesh; steps: number }> {
  const solver = new SolverHere(module);
  const { mesh } = await solver.ask({ ...question, job: 1 }, "opened");
  return { mesh, steps: solver.replies.filter(({ kind }) => kind === "progress").length };
}

it.each([
  ["made flat", { symmetry: null, cuts: [] }],
  ["and cut", { symmetry: null, cuts: ["strip=6-7@0.3"] }],
  ["and symmetric", { symmetry: { elements: ["x"], tolerance: 1e-6 }, cuts: [] }],
  [
    "and both",
    { symmetry: { elements: ["x"], tolerance: 1e-6 }, cuts: ["split=0:0,6", "split=3:4,8"] },
  ],
])("a file %s is opened from what is known of it", async (_, { symmetry, cuts }) => {
  const source = keepCopy("bent.obj", "obj", bentFile());
  const base: Base = { source, planarised: NEAREST, symmetry, cuts };
  const solved = await opened(openQuestion(base));
  const known = await opened(openKnownQuestion(base, solved.mesh));
  expect(solved.steps).toBeGreaterThan(0);
  expect(known.steps).toBe(0);
  expect(known.mesh.positions).toEqual(solved.mesh.positions);
  expect(known.mesh.vertices).toEqual(solved.mesh.vertices);
  expect(known.mesh.symmetry).toEqual(solved.mesh.symmetry);
});
