// SPDX-License-Identifier: MIT
// A recipe is opened by doing it again, and the result is held against its mark. All of it is one
// step of the history; if a part fails, nothing has happened.
import { meshHash } from "../share/mesh-hash.ts";
import type { OpenedMesh } from "../solver/protocol.ts";
import { placeCamera } from "./camera.ts";
import { run } from "./connection.ts";
import type { Design, Family } from "./design.ts";
import { deviationWords, isRounding } from "./deviating.ts";
import { editQuestion } from "./editing.ts";
import { findDirections } from "./exploring.ts";
import * as steps from "./history.ts";
import { freshDesign } from "./opening.ts";
import { deviation, type Recipe, type Steps } from "./recipe.ts";
import { showPresent, takeMesh } from "./showing.ts";
import { draft, history, notice, problem, unit } from "./store.ts";
import { inTurn } from "./turns.ts";

/** Of the mesh, model units: display coordinates span ten. */
export const sizeOf = ({ scale }: OpenedMesh["report"]): number => 10 / scale;

type Step = { readonly design: Design } | { readonly reason: string | null };

async function solved(design: Design): Promise<Step> {
  if (design.handles.length === 0) return { design };
  const answer = await run("opening the design", editQuestion(design, "solve"), "shown");
  if (!answer?.shape) return { reason: problem.value };
  return { design: { ...design, shape: answer.shape, report: answer.report } };
}

/** One family around `design`: found, evaluated and made exact. */
async function member(
  design: Design,
  given: Family,
  earlier: readonly Family[],
  someSliders: boolean,
): Promise<Step> {
  const { asked, eigenbasis } = given;
  const found = await findDirections(design, asked, eigenbasis);
  if (found === null) return { reason: problem.value };
  const count = given.coefficients.length;
  if (count > found || (count < found && !someSliders))
    return { reason: `The design sets ${count} variations where its edit has ${found}.` };
  const coefficients = Array.from({ length: found }, (_, k) => given.coefficients[k] ?? 0);
  const family: Family = { ...given, coefficients };
  const centre = design.shape;
  const next: Design = { ...design, variation: { ...family, centre, earlier, exact: true } };
  if (coefficients.every((x) => x === 0)) return { design: next };
  const vary = await run("opening the design", { kind: "vary", coefficients }, "shown");
  const exact = vary && (await run("opening the design", { kind: "exact" }, "shown"));
  if (!exact?.shape) return { reason: problem.value };
  return { design: { ...next, shape: exact.shape, report: exact.report } };
}

async function varied(design: Design, { families, someSliders = false }: Steps): Promise<Step> {
  let step: Step = { design };
  const earlier: Family[] = [];
  for (const family of families) {
    if (!("design" in step)) break;
    step = await member(step.design, family, [...earlier], someSliders);
    const found = "design" in step ? step.design.variation : null;
    if (found) earlier.push({ ...family, coefficients: found.coefficients });
  }
  return step;
}

/** The design of `recipe` on its mesh, which the solver has open; within a turn. */
export async function compute(recipe: Steps, opened: OpenedMesh): Promise<Step> {
  const { source, planarised, handles, settings, baseHash = null } = recipe;
  const fresh = { ...freshDesign(source, planarised, opened), handles, settings };
  takeMesh(fresh, opened);
  // Making a mesh flat may round differently elsewhere.
  if (baseHash !== null && planarised === null && meshHash(opened) !== baseHash)
    return {
      reason: "The mesh in the design is not the one that was edited (source.hash differs).",
    };
  if (handles.some((row) => row.vertex >= opened.report.vertices))
    return { reason: "The design moves points that its mesh does not have." };
  const edited = await solved(fresh);
  return "design" in edited ? varied(edited.design, recipe) : edited;
}

/** Within a turn; true if the design is there, otherwise the problem has been said. */
export async function replayNow(recipe: Steps): Promise<boolean> {
  const { source, planarised } = recipe;
  const question = { kind: "open", source, planarise: planarised } as const;
  const answer = await run("opening the design", question, "opened");
  const end = answer ? await compute(recipe, answer.mesh) : { reason: problem.value };
  if (!("design" in end)) {
    await showPresent();
    problem.value = end.reason;
    return false;
  }
  unit.value = recipe.unit;
  placeCamera(recipe.camera);
  draft.value = end.design;
  history.value = history.value ? steps.record(history.value, end.design) : steps.begin(end.design);
  if (answer) sayHowItCompares(recipe, end.design, answer.mesh);
  return true;
}

/** True if the design is there; otherwise the problem has been said. */
export async function replay(recipe: Recipe): Promise<boolean> {
  let opened = false;
  await inTurn(async () => {
    opened = await replayNow(recipe);
  });
  return opened;
}

/** More than rounding is no mere notice. */
function sayHowItCompares({ mark }: Steps, { shape }: Design, opened: OpenedMesh): void {
  if (!mark) {
    notice.value = "Opened: the design holds no result to compare with.";
    return;
  }
  const [off, size] = [deviation(mark, shape, opened.positions), sizeOf(opened.report)];
  const words = deviationWords(off, size, unit.value);
  const same = isRounding(off, size, unit.value);
  notice.value = same ? words : null;
  if (!same) problem.value = words;
}
