// SPDX-License-Identifier: MIT
// A recipe is opened by letting the core do it again, and the result is held against its mark. All
// of it is one step of the history; if a part fails, nothing has happened.

import type { Design, Family, Variation } from "../design/design.ts";
import { toDesign } from "../design/design-value.ts";
import * as steps from "../design/history.ts";
import type { Steps } from "../design/recipe.ts";
import { done, type Result, refuse } from "../result/result.ts";
import type { OpenedMesh, Shape, SliderLead } from "../solver/protocol.ts";
import { enqueue } from "./action-queue.ts";
import { placeCamera } from "./camera.ts";
import { baseOf, held, openQuestion, run, runUnseen } from "./connection.ts";
import { deviationWords, isRounding } from "./deviating.ts";
import { freshDesign } from "./opening.ts";
import type { Page } from "./page.ts";
import { type Received, receive, variantsOf } from "./receiving.ts";
import { showPresent, takeMesh } from "./showing.ts";
import { sliderLeads } from "./slider-leads.ts";

/** The size of the mesh, model units: display coordinates span ten. */
export const sizeOf = ({ scale }: OpenedMesh["report"]): number => 10 / scale;

interface Replayed {
  readonly design: Design;
  /** From the recorded result, model units. */
  readonly deviation: number;
}

/** The families with a slider for every direction that was found, or why that is not what they say. */
function withSliders(
  { families, someSliders = false }: Steps,
  directions: readonly number[],
): Family[] | string {
  const all: Family[] = [];
  for (const [k, family] of families.entries()) {
    const found = directions[k];
    if (found === undefined) return "The design varies an edit that moves nothing.";
    const count = family.coefficients.length;
    if (count > found || (count < found && !someSliders))
      return `The design sets ${count} variations where its edit has ${found}.`;
    const coefficients = Array.from({ length: found }, (_, i) => family.coefficients[i] ?? 0);
    all.push({ ...family, coefficients });
  }
  return all;
}

interface Solved extends Replayed {
  /** Of its variation. */
  readonly found: { readonly centre: Shape; readonly leads: readonly SliderLead[] } | null;
}

const beforeIt = (
  page: Page,
  { source, planarised, handles, settings }: Steps,
  on: OpenedMesh,
) => ({
  ...freshDesign(page, source, planarised, on),
  handles,
  settings,
});

/** The design of `recipe` on its mesh, which the solver has open. @param ask shows what comes, or not */
async function solveAgain(
  page: Page,
  label: string,
  recipe: Steps,
  fresh: Design,
  ask: typeof run,
): Promise<Result<Solved>> {
  const question = { kind: "replay", design: toDesign(recipe) } as const;
  const answer = await ask(page, label, question, "replayed");
  if (!answer.ok) return answer;
  const { shape, report, centre, leads, deviation, directions } = answer.value;
  const families = withSliders(recipe, directions);
  if (typeof families === "string") return refuse(families);
  const last = families.at(-1);
  const earlier = families.slice(0, -1);
  const variation: Variation | null = last ? { ...last, centre, earlier, exact: true } : null;
  const found = variation && { centre, leads };
  return done({ design: { ...fresh, shape, report, variation }, deviation, found });
}

/** The design of `recipe` on its mesh, which the solver has open; within a queued action. */
export async function compute(
  page: Page,
  recipe: Steps,
  opened: OpenedMesh,
): Promise<Result<Replayed>> {
  const fresh = beforeIt(page, recipe, opened);
  takeMesh(page, fresh, opened);
  const end = await solveAgain(page, "opening the design", recipe, fresh, run);
  if (!end.ok) return end;
  const { found } = end.value;
  held(page).centre = found?.centre ?? null;
  if (found) sliderLeads(page).value = found;
  return end;
}

/** The variants that came with a design, none of them shown; those that cannot be made are left out, and
 * all that were not made yet once somebody cancels. */
async function makeVariants(page: Page, recipe: Steps): Promise<Received[]> {
  const received: Received[] = [];
  const all = variantsOf(recipe);
  let opened = null as { readonly how: string; readonly mesh: OpenedMesh } | null;
  for (const [k, { name, steps: variant }] of all.entries()) {
    const label = `opening snapshot ${k + 1} of ${all.length}`;
    const base = baseOf(variant);
    const how = JSON.stringify([base.planarised, base.symmetry, base.cuts]);
    if (opened?.how !== how) {
      const answer = await runUnseen(page, label, openQuestion(base), "opened");
      if (!answer.ok && !answer.reason) break;
      opened = answer.ok ? { how, mesh: answer.value.mesh } : null;
    }
    if (!opened) continue;
    const { mesh } = opened;
    const end = await solveAgain(page, label, variant, beforeIt(page, variant, mesh), runUnseen);
    if (!end.ok && !end.reason) break;
    if (!end.ok) continue;
    const { design, deviation } = end.value;
    const same = isRounding(deviation, sizeOf(mesh.report), recipe.unit);
    received.push({ name, design, same });
  }
  return received;
}

async function openAndCompute(
  page: Page,
  recipe: Steps,
): Promise<Result<Replayed & { readonly mesh: OpenedMesh }>> {
  const question = openQuestion(baseOf(recipe));
  const answer = await run(page, "opening the design", question, "opened");
  if (!answer.ok) return answer;
  const { mesh } = answer.value;
  const end = await compute(page, recipe, mesh);
  return end.ok ? done({ ...end.value, mesh }) : end;
}

/** Does a design again, within a queued action; says how far what is there now differs from what was recorded, ""
 * where it does not. */
export async function replayNow(page: Page, recipe: Steps): Promise<Result<string>> {
  const end = await openAndCompute(page, recipe);
  if (!end.ok) {
    await showPresent(page);
    return end;
  }
  const { design, deviation, mesh } = end.value;
  page.unit.value = recipe.unit;
  placeCamera(page, recipe.camera);
  page.draft.value = design;
  page.history.value = page.history.value
    ? steps.record(page.history.value, design)
    : steps.begin(design);
  const differing = compared(page, recipe, deviation, mesh);
  // Once the design is there to be looked at; then the solver has it again.
  const variants = await makeVariants(page, recipe);
  const back = recipe.companions?.variants.length ? await showPresent(page) : undefined;
  if (back) return back;
  const came = receive(page, recipe.companions, variants);
  if (came && page.notice.value) page.notice.value = `${page.notice.value} ${came}`;
  return done(came && differing ? `${differing} ${came}` : differing);
}

/** A design that is there but differs is told as a refusal is. */
export const differingIn = (replayed: Result<string>): Result<string> =>
  replayed.ok && replayed.value ? refuse(replayed.value) : replayed;

/** True if the design is there; otherwise the problem has been said. */
export async function replay(page: Page, recipe: Steps): Promise<boolean> {
  let opened = false;
  await enqueue(page, async () => {
    const replayed = await replayNow(page, recipe);
    opened = replayed.ok;
    return differingIn(replayed);
  });
  return opened;
}

/** Notes that the design is as recorded; how it differs, in words, where it is more than rounding. */
function compared(page: Page, { mark }: Steps, off: number, opened: OpenedMesh): string {
  if (!mark) {
    page.notice.value = "Opened: the design holds no result to compare with.";
    return "";
  }
  const size = sizeOf(opened.report);
  const words = deviationWords(off, size, page.unit.value);
  const same = isRounding(off, size, page.unit.value);
  page.notice.value = same ? words : null;
  return same ? "" : words;
}
