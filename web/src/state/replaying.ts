// SPDX-License-Identifier: MIT
// A recipe is opened by letting the core do it again, and the result is held against its mark. All
// of it is one step of the history; if a part fails, nothing has happened.
import { toDesign } from "../share/design-value.ts";
import type { OpenedMesh } from "../solver/protocol.ts";
import { placeCamera } from "./camera.ts";
import { held, run } from "./connection.ts";
import type { Design, Family, Variation } from "./design.ts";
import { deviationWords, isRounding } from "./deviating.ts";
import { sliderLeads } from "./exploring.ts";
import * as steps from "./history.ts";
import { freshDesign } from "./opening.ts";
import type { Steps } from "./recipe.ts";
import { showPresent, takeMesh } from "./showing.ts";
import { draft, history, notice, problem, unit } from "./store.ts";
import { inTurn } from "./turns.ts";

/** Of the mesh, model units: display coordinates span ten. */
export const sizeOf = ({ scale }: OpenedMesh["report"]): number => 10 / scale;

/** `deviation`: from the recorded result, model units. */
type Outcome =
  | { readonly design: Design; readonly deviation: number }
  | { readonly reason: string | null };

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

/** The design of `recipe` on its mesh, which the solver has open; within a turn. */
export async function compute(recipe: Steps, opened: OpenedMesh): Promise<Outcome> {
  const { source, planarised, handles, settings } = recipe;
  const fresh = { ...freshDesign(source, planarised, opened), handles, settings };
  takeMesh(fresh, opened);
  const question = { kind: "replay", design: toDesign(recipe) } as const;
  const answer = await run("opening the design", question, "replayed");
  if (!answer) return { reason: problem.value };
  const { shape, report, centre, leads, deviation } = answer;
  const families = withSliders(recipe, answer.directions);
  if (typeof families === "string") return { reason: families };
  const last = families.at(-1);
  const earlier = families.slice(0, -1);
  const variation: Variation | null = last ? { ...last, centre, earlier, exact: true } : null;
  held.centre = variation && centre;
  if (variation) sliderLeads.value = { centre, leads };
  return { design: { ...fresh, shape, report, variation }, deviation };
}

/** Within a turn; true if the design is there, otherwise the problem has been said. */
export async function replayNow(recipe: Steps): Promise<boolean> {
  const { source, planarised } = recipe;
  const question = { kind: "open", source, planarise: planarised } as const;
  const answer = await run("opening the design", question, "opened");
  const end = answer ? await compute(recipe, answer.mesh) : { reason: problem.value };
  if (!answer || !("design" in end)) {
    await showPresent();
    problem.value = "reason" in end ? end.reason : null;
    return false;
  }
  unit.value = recipe.unit;
  placeCamera(recipe.camera);
  draft.value = end.design;
  history.value = history.value ? steps.record(history.value, end.design) : steps.begin(end.design);
  sayHowItCompares(recipe, end.deviation, answer.mesh);
  return true;
}

/** True if the design is there; otherwise the problem has been said. */
export async function replay(recipe: Steps): Promise<boolean> {
  let opened = false;
  await inTurn(async () => {
    opened = await replayNow(recipe);
  });
  return opened;
}

/** More than rounding is no mere notice. */
function sayHowItCompares({ mark }: Steps, off: number, opened: OpenedMesh): void {
  if (!mark) {
    notice.value = "Opened: the design holds no result to compare with.";
    return;
  }
  const size = sizeOf(opened.report);
  const words = deviationWords(off, size, unit.value);
  const same = isRounding(off, size, unit.value);
  notice.value = same ? words : null;
  if (!same) problem.value = words;
}
