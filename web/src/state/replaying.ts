// SPDX-License-Identifier: MIT
// A recipe is opened by doing it again, and the result is held against its mark. All of it is one
// step of the history; if a part fails, nothing has happened.
import type { OpenedMesh } from "../solver/protocol.ts";
import { placeCamera } from "./camera.ts";
import { run } from "./connection.ts";
import type { Design, Family } from "./design.ts";
import { editQuestion } from "./editing.ts";
import { findDirections } from "./exploring.ts";
import * as steps from "./history.ts";
import { freshDesign } from "./opening.ts";
import { deviation, type Recipe } from "./recipe.ts";
import { showPresent, takeMesh } from "./showing.ts";
import { draft, history, notice, problem, unit } from "./store.ts";
import { inTurn } from "./turns.ts";
import { formatLength } from "./units.ts";

type Step = { readonly design: Design } | { readonly reason: string | null };

async function solved(design: Design): Promise<Step> {
  if (design.handles.length === 0) return { design };
  const answer = await run("opening the design", editQuestion(design, "solve"), "shown");
  if (!answer?.shape) return { reason: problem.value };
  return { design: { ...design, shape: answer.shape, report: answer.report } };
}

/** One family around `design`: found, evaluated and made exact. */
async function member(design: Design, family: Family, earlier: readonly Family[]): Promise<Step> {
  const { coefficients, asked, eigenbasis } = family;
  const found = await findDirections(design, asked, eigenbasis);
  if (found !== coefficients.length) {
    const given = `This link sets ${coefficients.length} variations where its edit has ${found}.`;
    return { reason: found === null ? problem.value : given };
  }
  const centre = design.shape;
  const next: Design = { ...design, variation: { ...family, centre, earlier, exact: true } };
  if (coefficients.every((x) => x === 0)) return { design: next };
  const vary = await run("opening the design", { kind: "vary", coefficients }, "shown");
  const exact = vary && (await run("opening the design", { kind: "exact" }, "shown"));
  if (!exact?.shape) return { reason: problem.value };
  return { design: { ...next, shape: exact.shape, report: exact.report } };
}

async function varied(design: Design, { families }: Recipe): Promise<Step> {
  let step: Step = { design };
  for (const [k, family] of families.entries()) {
    if (!("design" in step)) break;
    step = await member(step.design, family, families.slice(0, k));
  }
  return step;
}

/** The design of `recipe` on its mesh, which the solver has open; within a turn. */
export async function compute(recipe: Recipe, opened: OpenedMesh): Promise<Step> {
  const { source, planarised, handles, settings } = recipe;
  const fresh = { ...freshDesign(source, planarised, opened), handles, settings };
  takeMesh(fresh, opened);
  if (handles.some((row) => row.vertex >= opened.report.vertices))
    return { reason: "This link moves points that its mesh does not have." };
  const edited = await solved(fresh);
  return "design" in edited ? varied(edited.design, recipe) : edited;
}

async function replayNow(recipe: Recipe): Promise<boolean> {
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
  if (answer) announce(recipe, end.design, answer.mesh.positions);
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

function announce({ mark }: Recipe, design: Design, base: Float64Array): void {
  const off = deviation(mark, design.shape, base);
  notice.value =
    off === 0
      ? "Verified: the same result as when it was shared, to the last bit."
      : `Replayed: differs from the shared result by up to ${formatLength(off, unit.value)}.`;
}
