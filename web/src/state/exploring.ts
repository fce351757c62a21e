// SPDX-License-Identifier: MIT
// Variations around an edit, and the exact projection of what is shown.
import { client, frame, run } from "./connection.ts";
import type { Design, Variation } from "./design.ts";
import { commit } from "./editing.ts";
import * as steps from "./history.ts";
import { planarise } from "./opening.ts";
import { dimension, draft, figures, history, mesh } from "./store.ts";

export async function explore(): Promise<void> {
  const design = draft.value;
  const steady = history.value;
  if (!design || !steady) return;
  if (design.variation && !design.variation.exact) await makeExact();
  const question = { kind: "explore", dimension: dimension.value, eigenbasis: false } as const;
  const answer = await run("finding variations", question, "explored");
  if (!answer) return;
  const coefficients = Array.from({ length: answer.report.dimension }, () => 0);
  const now = draft.value ?? design;
  const next: Design = {
    ...now,
    variation: { dimension: coefficients.length, coefficients, exact: true },
  };
  draft.value = next;
  history.value = steps.record(history.value ?? steady, next);
}

function varied(index: number, value: number): (Design & { variation: Variation }) | null {
  const design = draft.value;
  if (!design?.variation) return null;
  const coefficients = design.variation.coefficients.map((x, k) => (k === index ? value : x));
  return { ...design, variation: { ...design.variation, coefficients, exact: false } };
}

/** Each frame of a slider: no solve, only B x. */
export function previewVariation(index: number, value: number): void {
  const next = varied(index, value);
  if (!next) return;
  draft.value = next;
  void frame({ kind: "vary", coefficients: next.variation.coefficients });
}

/** On release the design becomes exact again. */
export async function commitVariation(index: number, value: number): Promise<void> {
  const next = varied(index, value);
  if (!next) return;
  client.dropStreams();
  draft.value = next;
  await frame({ kind: "vary", coefficients: next.variation.coefficients });
  const exact = { ...next, variation: { ...next.variation, exact: true } };
  await commit(exact, { kind: "exact" }, "making exact");
}

/** The nearest flat design to what is shown; an opened mesh that is not flat is planarised. */
export async function makeExact(): Promise<void> {
  const design = draft.value;
  if (!design) return;
  if (mesh.value && !mesh.value.report.flat) {
    await planarise();
    return;
  }
  const variation = design.variation ? { ...design.variation, exact: true } : null;
  if (figures.value.movedVertices > 0) {
    await commit({ ...design, variation }, { kind: "exact" }, "making exact");
  }
}
