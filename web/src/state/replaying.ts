// SPDX-License-Identifier: MIT
// A recipe is opened by doing it again, and the result is held against its mark.
import { run } from "./connection.ts";
import { commit, commitEdit } from "./editing.ts";
import { adoptMesh, sourceName } from "./opening.ts";
import { deviation, type Recipe } from "./recipe.ts";
import { draft, mesh, notice, problem, unit } from "./store.ts";
import { formatLength } from "./units.ts";

/** True if the design is there; otherwise the problem has been said. */
export async function replay(recipe: Recipe): Promise<boolean> {
  const { source, planarised } = recipe;
  const opened = await run(
    "opening the design",
    { kind: "open", source, planarise: planarised },
    "opened",
  );
  if (!opened) return false;
  unit.value = recipe.unit;
  adoptMesh(source, sourceName(source), planarised, opened.mesh);
  const count = opened.mesh.report.vertices;
  if (recipe.handles.some((row) => row.vertex >= count)) {
    problem.value =
      "This link moves points that its mesh does not have; the mesh is shown unedited.";
    return true;
  }
  if (!draft.value) return false;
  await commitEdit({ ...draft.value, handles: recipe.handles, settings: recipe.settings }, "solve");
  if (recipe.variation) await replayVariation(recipe.variation);
  announce(recipe);
  return true;
}

async function replayVariation(coefficients: readonly number[]): Promise<void> {
  const question = { kind: "explore", dimension: coefficients.length, eigenbasis: false } as const;
  const found = await run("finding variations", question, "explored");
  if (!found || !draft.value) return;
  const varied = await run("varying", { kind: "vary", coefficients }, "shown");
  if (!varied) return;
  const variation = { dimension: coefficients.length, coefficients, exact: true };
  await commit({ ...draft.value, variation }, { kind: "exact" }, "making exact");
}

function announce({ mark }: Recipe): void {
  const design = draft.value;
  const base = mesh.value?.positions;
  if (!design || !base || problem.value) return;
  const off = deviation(mark, design.shape, base);
  notice.value =
    off === 0
      ? "Verified: the same result as when it was shared, to the last bit."
      : `Replayed: differs from the shared result by up to ${formatLength(off, unit.value)}.`;
}
