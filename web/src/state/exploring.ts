// SPDX-License-Identifier: MIT
// Variations around an edit, and the exact projection of what is shown.
import { signal } from "@preact/signals";
import type { Shape, SliderLead, VariationFamily } from "../solver/protocol.ts";
import { client, frame, held, run, runUnseen } from "./connection.ts";
import { type Design, type Family, familyOf, toTargets, type Variation } from "./design.ts";
import { commit } from "./editing.ts";
import * as steps from "./history.ts";
import { planariseNow } from "./opening.ts";
import { show } from "./showing.ts";
import {
  baseFlat,
  dimension,
  draft,
  eigenbasis,
  figures,
  history,
  notice,
  variationWeights,
} from "./store.ts";
import { inTurn } from "./turns.ts";

type Varied = Design & { readonly variation: Variation };

/** What each slider of the family around a shape does. */
export const sliderLeads = signal<{
  readonly centre: Shape;
  readonly leads: readonly SliderLead[];
} | null>(null);

/** Finds the directions around the shape that the solver shows; how many there are, or null. */
async function findDirections(design: Design, family: VariationFamily): Promise<number | null> {
  const answer = await run("finding variations", { kind: "explore", family }, "explored");
  if (answer) {
    held.centre = design.shape;
    sliderLeads.value = { centre: design.shape, leads: answer.leads };
  }
  return answer?.report.dimension ?? null;
}

/** The families that led to the shape of `design`; one that was not used led nowhere. */
function earlierOf({ variation }: Design): readonly Family[] {
  if (!variation) return [];
  const { earlier } = variation;
  if (variation.coefficients.every((x) => x === 0)) return earlier;
  return [...earlier, familyOf(variation)];
}

export const explore = (): Promise<void> =>
  inTurn(async () => {
    if (draft.value?.variation && !draft.value.variation.exact) await makeExactNow();
    const design = draft.value;
    if (!design || !history.value) return;
    const weights = variationWeights.value;
    const family: VariationFamily = {
      asked: dimension.value,
      eigenbasis: eigenbasis.value,
      ...(weights && { weights }),
    };
    const found = await findDirections(design, family);
    if (found === null || !history.value) return;
    const variation: Variation = {
      ...family,
      coefficients: Array.from({ length: found }, () => 0),
      centre: design.shape,
      earlier: earlierOf(design),
      exact: true,
    };
    const next: Design = { ...design, variation };
    draft.value = next;
    notice.value = null;
    history.value = steps.record(history.value, next);
  });

/** True once the solver can evaluate the sliders of `design`: after an undo it may have to look
 * for the directions again, which gives the same ones. */
export async function ensureDirections(design: Design): Promise<boolean> {
  const { variation } = design;
  if (!variation) return false;
  if (held.base && held.centre === variation.centre) return true;
  const before: Design = { ...design, shape: variation.centre };
  const targets = toTargets(design.handles);
  const { settings } = design;
  const shape = variation.centre;
  const restore = { kind: "restore", targets, settings, shape, keep: false } as const;
  if (!(await runUnseen("finding variations", restore, "shown"))) return false;
  const found = await findDirections(before, familyOf(variation));
  return (await show(design)) && found === variation.coefficients.length;
}

function varied(index: number, value: number): Varied | null {
  const design = draft.value;
  if (!design?.variation) return null;
  const coefficients = design.variation.coefficients.map((x, k) => (k === index ? value : x));
  return { ...design, variation: { ...design.variation, coefficients, exact: false } };
}

let preparing = false;

/** Each frame of a slider: no solve, only B x. */
export function previewVariation(index: number, value: number): void {
  const next = varied(index, value);
  if (!next || preparing) return;
  if (held.centre === next.variation.centre) {
    draft.value = next;
    void frame({ kind: "vary", coefficients: next.variation.coefficients });
    return;
  }
  const design = draft.value;
  preparing = true;
  void inTurn(async () => {
    if (design) await ensureDirections(design);
  }).finally(() => {
    preparing = false;
  });
}

/** On release the design becomes exact again. */
export async function commitVariation(
  index: number,
  value: number,
  burst: string | null = null,
): Promise<void> {
  client.dropStreams();
  await inTurn(async () => {
    const next = varied(index, value);
    const steady = history.value?.present;
    if (next && steady) await commitVaried(next, steady, burst);
  }, burst);
}

/** Evaluates the sliders of `next`, makes the result exact and records it. */
async function commitVaried(next: Varied, steady: Design, burst: string | null): Promise<void> {
  const ready = held.centre === next.variation.centre || (await ensureDirections(steady));
  const { coefficients } = next.variation;
  const shown = ready && (await run("varying", { kind: "vary", coefficients }, "shown"));
  if (!shown) {
    await show(steady);
    return;
  }
  const exact: Design = { ...next, variation: { ...next.variation, exact: true } };
  await commit(exact, { kind: "exact" }, "making exact", burst);
}

/** Within a turn: the nearest flat design to what is shown. */
async function makeExactNow(): Promise<void> {
  const design = draft.value;
  if (!design) return;
  if (!baseFlat.value) {
    await planariseNow();
    return;
  }
  const variation = design.variation ? { ...design.variation, exact: true } : null;
  if (figures.value.movedVertices > 0) {
    await commit({ ...design, variation }, { kind: "exact" }, "making exact");
  }
}

/** The nearest flat design to what is shown; an opened mesh that is not flat is planarised. */
export const makeExact = (): Promise<void> => inTurn(makeExactNow);
