// SPDX-License-Identifier: MIT
// Variations around an edit, and the exact projection of what is shown.

import {
  type Design,
  type Family,
  familyOf,
  toTargets,
  type Variation,
} from "../../design/design.ts";
import { isFlat } from "../../design/flatness.ts";
import * as steps from "../../design/history.ts";
import { done, GIVEN_UP, type Result } from "../../result/result.ts";
import type { VariationFamily } from "../../solver/protocol.ts";
import { enqueue, type Outcome } from "../../state/action-queue.ts";
import { client, frame, held, run, runUnseen } from "../../state/connection.ts";
import { commit } from "../../state/editing.ts";
import { planariseNow } from "../../state/opening.ts";
import { kept, type Page } from "../../state/page.ts";
import { restorePresent, show } from "../../state/showing.ts";
import { sliderLeads } from "../../state/slider-leads.ts";

type Varied = Design & { readonly variation: Variation };

/** Finds the directions around the shape that the solver shows; how many there are. */
async function findDirections(
  page: Page,
  design: Design,
  family: VariationFamily,
): Promise<Result<number>> {
  const answer = await run(page, "finding variations", { kind: "explore", family }, "explored");
  if (!answer.ok) return answer;
  held(page).centre = design.shape;
  sliderLeads(page).value = { centre: design.shape, leads: answer.value.leads };
  return done(answer.value.report.dimension);
}

/** The families that led to the shape of `design`; one that was not used led nowhere. */
function earlierOf({ variation }: Design): readonly Family[] {
  if (!variation) return [];
  const { earlier } = variation;
  if (variation.coefficients.every((x) => x === 0)) return earlier;
  return [...earlier, familyOf(variation)];
}

export const explore = (page: Page): Outcome =>
  enqueue(page, async () => {
    const inexact = page.draft.value?.variation && !page.draft.value.variation.exact;
    const made = inexact && (await makeExactNow(page));
    if (made && !made.ok) return made;
    const design = page.draft.value;
    if (!design || !page.history.value) return;
    const weights = page.variationWeights.value;
    const family: VariationFamily = {
      asked: page.dimension.value,
      eigenbasis: page.eigenbasis.value,
      ...(weights && { weights }),
    };
    const found = await findDirections(page, design, family);
    if (!found.ok || !page.history.value) return found;
    const variation: Variation = {
      ...family,
      coefficients: Array.from({ length: found.value }, () => 0),
      centre: design.shape,
      earlier: earlierOf(design),
      exact: true,
    };
    const next: Design = { ...design, variation };
    page.draft.value = next;
    page.notice.value = null;
    page.history.value = steps.record(page.history.value, next);
    return found;
  });

/** Lets the solver be able to evaluate the sliders of `design`: after an undo it may have to look
 * for the directions again, which gives the same ones. */
export async function ensureDirections(page: Page, design: Design): Promise<Result<unknown>> {
  const { variation } = design;
  if (!variation) return GIVEN_UP;
  if (held(page).base && held(page).centre === variation.centre) return done(variation);
  const before: Design = { ...design, shape: variation.centre };
  const targets = toTargets(design.handles);
  const { settings } = design;
  const shape = variation.centre;
  const restore = { kind: "restore", targets, settings, shape, keep: false } as const;
  const restored = await runUnseen(page, "finding variations", restore, "shown");
  if (!restored.ok) return restored;
  const found = await findDirections(page, before, familyOf(variation));
  const shown = await show(page, design);
  if (!found.ok || !shown.ok) return found.ok ? shown : found;
  return found.value === variation.coefficients.length ? found : GIVEN_UP;
}

function varied(page: Page, index: number, value: number): Varied | null {
  const design = page.draft.value;
  if (!design?.variation) return null;
  const coefficients = design.variation.coefficients.map((x, k) => (k === index ? value : x));
  return { ...design, variation: { ...design.variation, coefficients, exact: false } };
}

interface Own {
  preparing: boolean;
}

const own = kept((): Own => ({ preparing: false }));

/** Each frame of a slider: no solve, only B x. */
export function previewVariation(page: Page, index: number, value: number): void {
  const next = varied(page, index, value);
  if (!next || own(page).preparing) return;
  if (held(page).centre === next.variation.centre) {
    page.draft.value = next;
    void frame(page, { kind: "vary", coefficients: next.variation.coefficients });
    return;
  }
  const design = page.draft.value;
  own(page).preparing = true;
  void enqueue(page, async () => {
    return design ? ensureDirections(page, design) : undefined;
  }).finally(() => {
    own(page).preparing = false;
  });
}

/** Sets a slider when it is let go of: the design becomes exact again. */
export function commitVariation(
  page: Page,
  index: number,
  value: number,
  burst: string | null = null,
): Outcome {
  client(page).dropStreams();
  return enqueue(
    page,
    async () => {
      const next = varied(page, index, value);
      const steady = page.history.value?.present;
      return next && steady ? commitVaried(page, next, steady, burst) : undefined;
    },
    burst,
  );
}

/** Evaluates the sliders of `next`, makes the result exact and records it. */
async function commitVaried(
  page: Page,
  next: Varied,
  steady: Design,
  burst: string | null,
): Outcome {
  const { centre, coefficients } = next.variation;
  const ready = held(page).centre === centre ? done(centre) : await ensureDirections(page, steady);
  if (!ready.ok) return restorePresent(page, ready);
  const shown = await run(page, "varying", { kind: "vary", coefficients }, "shown");
  if (!shown.ok) return restorePresent(page, shown);
  const exact: Design = { ...next, variation: { ...next.variation, exact: true } };
  return commit(page, exact, { kind: "exact" }, "making exact", burst);
}

/** Shows the nearest flat design to what is shown; within a turn. */
async function makeExactNow(page: Page): Outcome {
  const design = page.draft.value;
  if (!design) return;
  if (!page.baseFlat.value) return planariseNow(page);
  const said = alreadyExact(page, design);
  if (said) {
    // What is read aloud is read again only if it changes.
    page.notice.value = page.notice.value === said ? `${said}\u00a0` : said;
    return;
  }
  const variation = design.variation ? { ...design.variation, exact: true } : null;
  return commit(page, { ...design, variation }, { kind: "exact" }, "making exact");
}

/** What is said of a design that is as exact as it can become; "" of any other. */
function alreadyExact(page: Page, { settings, variation }: Design): string {
  const figures = page.figures.value;
  if (isFlat(figures) && (variation?.exact ?? true)) return "Already exact: every panel is flat.";
  if (figures.movedVertices > 0) return "";
  return `Already exact: every panel is flat up to the tolerance of ${settings.tolerance} mm/m.`;
}

/** The nearest flat design to what is shown; an opened mesh that is not flat is planarised. */
export const makeExact = (page: Page): Outcome => enqueue(page, () => makeExactNow(page));
