// SPDX-License-Identifier: MIT
// Opening the user's files. A design, as text or in a GLB or 3DM, opens as that design.
import type { Context } from "../rhino/context.ts";
import { fromDesign } from "../share/design-value.ts";
import type {
  DesignReading,
  FileFormat,
  OpenedMesh,
  Source,
  StoredDesign,
} from "../solver/protocol.ts";
import { run } from "./connection.ts";
import { type Design, toTargets } from "./design.ts";
import { distance, formatSmall, isRounding } from "./deviating.ts";
import * as steps from "./history.ts";
import { adopt, freshDesign } from "./opening.ts";
import type { Steps } from "./recipe.ts";
import { compute, replayNow, sizeOf } from "./replaying.ts";
import { takeMesh } from "./showing.ts";
import {
  contextHidden,
  contexts,
  draft,
  history,
  importReport,
  notice,
  problem,
  unit,
} from "./store.ts";
import { inTurn } from "./turns.ts";
import type { Unit } from "./units.ts";

const FORMATS: readonly FileFormat[] = ["obj", "off", "ply", "glb"];

function finish(design: Design, said: string): void {
  draft.value = design;
  history.value = history.value ? steps.record(history.value, design) : steps.begin(design);
  problem.value = null;
  notice.value = said;
}

/** The stored shape itself, with as much of its recipe as is known. */
async function asStored(design: Design, { shape }: StoredDesign, why: string): Promise<void> {
  const { handles, settings, variation } = design;
  const targets = toTargets(handles);
  const keep = variation !== null;
  const answer = await run(
    "opening the design",
    { kind: "restore", targets, settings, shape, keep },
    "shown",
  );
  if (!answer) return;
  const report = { ...design.report, ...answer.report };
  finish({ ...design, shape, report }, `Opened as it was stored. ${why}`);
}

/** Does the stored recipe again; where that gives another shape today, the stored one counts. */
async function reopen(
  source: Source,
  opened: OpenedMesh,
  stored: StoredDesign,
  reading: DesignReading,
): Promise<void> {
  const text = fromDesign(reading);
  if (!text.ok) {
    const plain = freshDesign(source, null, opened);
    takeMesh(plain, opened);
    return asStored(plain, stored, text.reason);
  }
  // The base in the file is that of the design, whatever became of where it came from.
  const sample = text.value.source?.kind === "sample" ? text.value.source : null;
  const recipe: Steps = { ...text.value, source: sample ?? source, baseHash: null, camera: null };
  const end = await compute(recipe, opened);
  unit.value = recipe.unit;
  const off = "design" in end ? distance(end.design.shape, stored.shape, opened.positions) : null;
  if ("design" in end && off === 0) {
    finish(end.design, "Verified: the same result as when it was stored, to the last bit.");
    return;
  }
  const size = sizeOf(opened.report);
  const rounding = off !== null && isRounding(off, size, recipe.unit);
  const differs = off === null ? "It cannot be computed again here." : differing(off, recipe.unit);
  if ("design" in end && rounding) return asStored(end.design, stored, `${differs}: rounding.`);
  const { planarised, handles, settings } = recipe;
  const fresh = { ...freshDesign(recipe.source, planarised, opened), handles, settings };
  await asStored(fresh, stored, off === null ? differs : `${differs}.`);
}

const differing = (off: number, of: Unit): string =>
  `Recomputed here it differs by up to ${formatSmall(off, of)}`;

/** Characters. */
const LONGEST_DESIGN = 64 * 2 ** 20;

/** A design as text: what is wrong with it is said, or it is done again. */
async function openDesign(file: File): Promise<void> {
  const refuse = (reason: string): void => {
    problem.value = `${file.name}: ${reason}`;
  };
  if (file.size > LONGEST_DESIGN) return refuse("A design has at most 64 MB.");
  const text = await file.text().catch(() => null);
  if (text === null) return refuse("It could not be read. Open it again.");
  const answer = await run(`reading ${file.name}`, { kind: "readDesign", text }, "design");
  if (!answer) return;
  const read = fromDesign(answer.reading);
  if (!read.ok) return refuse(read.reason);
  const { source, meshName } = read.value;
  if (!source)
    return refuse(`Its mesh, ${meshName.slice(0, 100)}, lies beside it. Open it as a GLB instead.`);
  const opened = await replayNow({ ...read.value, source, camera: null });
  if (!opened && problem.value) refuse(problem.value);
}

function keepContext(source: Source, context: Context | null): void {
  if (context) contexts.value = new Map([...contexts.value, [source, context]]);
  contextHidden.value = false;
}

/** A design again, or a mesh with what was done to it and what was left out. */
async function openModel(file: File): Promise<void> {
  const { name } = file;
  const answer = await run(`reading ${name}`, { kind: "unpack", file, name }, "unpacked");
  if (!answer) return;
  const { mesh, design, unit: unitOfFile, context, remarks } = answer.model;
  if (design) {
    const before = draft.value;
    await openDesign(new File([design], name));
    if (draft.value && draft.value !== before) keepContext(draft.value.source, context);
    return;
  }
  const read = { kind: "read", file: new Blob([mesh as BlobPart]), name, format: "obj" } as const;
  const opened = await run(`reading ${name}`, read, "opened");
  if (!opened?.source) return;
  const { report } = opened.mesh;
  const warnings = [...remarks, ...report.warnings];
  adopt(opened.source, null, { ...opened.mesh, report: { ...report, warnings } });
  keepContext(opened.source, context);
  if (unitOfFile) unit.value = unitOfFile;
  importReport.value = true;
}

const extensionOf = (name: string): string => name.split(".").at(-1)?.toLowerCase() ?? "";

async function openNow(file: File): Promise<void> {
  const { name } = file;
  const extension = extensionOf(name);
  if (extension === "json") return openDesign(file);
  if (extension === "3dm") return openModel(file);
  const format = FORMATS.find((f) => f === extension);
  if (!format) {
    problem.value = `${name} cannot be read. Use an OBJ, OFF, PLY, GLB or 3DM file, or a design (JSON).`;
    return;
  }
  const question = { kind: "read", file, name, format } as const;
  const answer = await run(`reading ${name}`, question, "opened");
  if (!answer?.source) return;
  const { stored } = answer;
  if (stored?.design) return reopen(answer.source, answer.mesh, stored, stored.design);
  adopt(answer.source, null, answer.mesh);
  importReport.value = true;
}

export const openFile = (file: File): Promise<void> => inTurn(() => openNow(file));
