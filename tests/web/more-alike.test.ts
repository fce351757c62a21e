// SPDX-License-Identifier: MIT
import { expect, it, vi } from "vitest";
import { loadPlanish } from "../parity/support/planish.ts";
import { SolverHere } from "../parity/support/solver-here.ts";

vi.mock("../../web/src/solver/documents.ts", async () => {
  const { loadDocuments } = await import("../parity/support/planish.ts");
  return { loadDocuments };
});

it("while panels are made more alike the steps so far are told, and no residual", async () => {
  const solver = new SolverHere(await loadPlanish());
  await solver.openSample("vault", 4);
  const asked = {
    move: 0.2,
    types: 0,
    keepBoundary: false,
    within: 0.005,
    mirrored: false,
    tolerance: 1e-6,
    limits: [],
  };
  await solver.ask({ kind: "alike", job: 2, asked }, "progress");
  const told = solver.replies.flatMap((reply) => (reply.kind === "progress" ? [reply] : []));
  const steps = told.map(({ step }) => step);
  expect(steps.length).toBeGreaterThan(0);
  expect(steps).toEqual([...new Set(steps)].sort((a, b) => a - b));
  expect(steps[0]).toBeGreaterThan(0);
  expect(told.map(({ residual }) => residual)).toEqual(steps.map(() => 0));
});
