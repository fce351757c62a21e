// SPDX-License-Identifier: MIT
// The design that is shown as the core writes it: its values, and as text with what goes along beside it.
import { withBeside } from "../design/beside-text.ts";
import type { Camera } from "../design/camera.ts";
import { toDesign } from "../design/design-value.ts";
import { recipeOf, type Steps } from "../design/recipe.ts";
import { type VariantJson, variantJson } from "../design/variant-text.ts";
import { done, GIVEN_UP, type Result } from "../result/result.ts";
import type { DesignValue } from "../solver/protocol.ts";
import { run } from "../state/connection.ts";
import { readMark } from "../state/marking.ts";
import type { Page } from "../state/page.ts";
import { companionsOf, type Taken } from "./companions.ts";

async function shownSteps(page: Page): Promise<Result<Steps>> {
  const design = page.history.value?.present;
  const mark = design ? await readMark(page, design.shape) : GIVEN_UP;
  if (!design || !mark.ok) return mark.ok ? GIVEN_UP : mark;
  return done(recipeOf(design, page.unit.value, null, mark.value));
}

/** @param whole with the mesh itself, which goes along with cuts always */
async function designOf(steps: Steps, whole: boolean): Promise<DesignValue> {
  const { source, settings } = steps;
  const rides = source.kind === "file" && (whole || settings.cuts.length > 0);
  const bytes = rides ? new Uint8Array(await source.bytes.arrayBuffer()) : undefined;
  return toDesign(steps, bytes);
}

/** What makes the design again; within a queued action, as all that follows. */
export async function designValue(page: Page, whole: boolean): Promise<Result<DesignValue>> {
  const steps = await shownSteps(page);
  return steps.ok ? done(await designOf(steps.value, whole)) : steps;
}

export interface TextOptions {
  /** In a link what repeats in the mesh's file stays compressible. */
  readonly format: "json" | "link";
  /** What the page is doing meanwhile. */
  readonly label: string;
  readonly camera: Camera | null;
  readonly taken: Taken;
}

async function textOf(
  page: Page,
  { format, label }: TextOptions,
  design: DesignValue,
): Promise<Result<string>> {
  const question = { kind: "export", format, design, offset: null } as const;
  const answer = await run(page, label, question, "exported");
  return answer.ok ? done(new TextDecoder().decode(answer.value.bytes)) : answer;
}

/** The design's JSON, and beside it what was written and kept under names here. */
export async function designText(page: Page, options: TextOptions): Promise<Result<string>> {
  const steps = await shownSteps(page);
  if (!steps.ok) return steps;
  const text = await textOf(page, options, await designOf(steps.value, true));
  if (!text.ok) return text;
  const companions = await companionsOf(page, options.taken);
  const variants: VariantJson[] = [];
  for (const { name, steps: done } of companions.variants) {
    const variant = await textOf(page, options, toDesign({ ...steps.value, ...done }));
    if (!variant.ok) return variant;
    variants.push(variantJson(name, variant.value));
  }
  return done(withBeside(text.value, { camera: options.camera, companions }, variants));
}
