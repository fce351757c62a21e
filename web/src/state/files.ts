// SPDX-License-Identifier: MIT
// Opening the user's files. A GLB that holds a design opens as that design.
import { readDesign, sameShape } from "../share/design-text.ts";
import type { FileFormat, OpenedMesh, Source, StoredDesign } from "../solver/protocol.ts";
import { run } from "./connection.ts";
import { type Design, toTargets } from "./design.ts";
import * as steps from "./history.ts";
import { adopt, freshDesign } from "./opening.ts";
import type { Recipe } from "./recipe.ts";
import { compute } from "./replaying.ts";
import { takeMesh } from "./showing.ts";
import { draft, history, importReport, notice, problem, unit } from "./store.ts";
import { inTurn } from "./turns.ts";

const FORMATS: readonly FileFormat[] = ["obj", "off", "ply", "glb"];

function finish(design: Design, said: string): void {
  draft.value = design;
  history.value = history.value ? steps.record(history.value, design) : steps.begin(design);
  problem.value = null;
  notice.value = said;
}

/** The stored shape itself, with as much of its recipe as is known. */
async function asStored(design: Design, { shape }: StoredDesign, why: string): Promise<void> {
  const { handles, settings } = design;
  const targets = toTargets(handles);
  const question = { kind: "restore", targets, settings, shape, keep: false } as const;
  const answer = await run("opening the design", question, "shown");
  if (!answer) return;
  const report = { ...design.report, ...answer.report };
  finish({ ...design, shape, report, variation: null }, `Opened as it was stored. ${why}`);
}

/** Does the stored recipe again; where that gives another shape today, the stored one counts. */
async function reopen(source: Source, opened: OpenedMesh, stored: StoredDesign): Promise<void> {
  const text = readDesign(stored.design);
  if (!text.ok) {
    const plain = freshDesign(source, false, opened);
    takeMesh(plain, opened);
    return asStored(plain, stored, text.reason);
  }
  const recipe: Recipe = { ...text.value, source: text.value.source ?? source, camera: null };
  const end = await compute(recipe, opened);
  unit.value = recipe.unit;
  if ("design" in end && sameShape(end.design.shape, stored.shape)) {
    finish(end.design, "Verified: the same result as when it was stored, to the last bit.");
    return;
  }
  const { planarised, handles, settings } = recipe;
  const fresh = { ...freshDesign(recipe.source, planarised, opened), handles, settings };
  await asStored(fresh, stored, "Computing it again gives a slightly different shape today.");
}

export const openFile = (file: File): Promise<void> =>
  inTurn(async () => {
    const { name } = file;
    const extension = name.split(".").at(-1)?.toLowerCase() ?? "";
    const format = FORMATS.find((f) => f === extension);
    if (!format) {
      problem.value = `${name} cannot be read. Use an OBJ, OFF, PLY or GLB file.`;
      return;
    }
    const question = { kind: "read", file, name, format } as const;
    const answer = await run(`reading ${name}`, question, "opened");
    if (!answer?.source) return;
    if (answer.stored?.design) {
      await reopen(answer.source, answer.mesh, answer.stored);
      return;
    }
    adopt(answer.source, false, answer.mesh);
    importReport.value = true;
  });
