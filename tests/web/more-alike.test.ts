// SPDX-License-Identifier: MIT
import { expect, it, vi } from "vitest";
import { Dispatcher } from "../../web/src/solver/dispatch.ts";
import type { Reply } from "../../web/src/solver/protocol.ts";
import { loadPlanish } from "../parity/support/planish.ts";

vi.mock("../../web/src/solver/documents.ts", async () => {
  const { loadDocuments } = await import("../parity/support/planish.ts");
  return { loadDocuments };
});

it("while panels are made more alike the steps so far are told, and no residual", async () => {
  const replies: Reply[] = [];
  const dispatcher = new Dispatcher(await loadPlanish(), (reply) => replies.push(reply));
  const source = { kind: "sample", name: "vault", size: 4 } as const;
  await dispatcher.handle({
    kind: "open",
    job: 1,
    source,
    planarise: null,
    symmetry: null,
    cuts: [],
  });
  replies.length = 0;
  await dispatcher.handle({
    kind: "alike",
    job: 2,
    asked: {
      move: 0.2,
      types: 0,
      keepBoundary: false,
      within: 0.005,
      mirrored: false,
      tolerance: 1e-6,
      limits: [],
    },
  });
  const told = replies.flatMap((reply) => (reply.kind === "progress" ? [reply] : []));
  const steps = told.map(({ step }) => step);
  expect(steps.length).toBeGreaterThan(0);
  expect(steps).toEqual([...new Set(steps)].sort((a, b) => a - b));
  expect(steps[0]).toBeGreaterThan(0);
  expect(told.map(({ residual }) => residual)).toEqual(steps.map(() => 0));
});
