// SPDX-License-Identifier: MIT
// Opening the user's files. A design, as text or in a GLB or 3DM, opens as that design.

import { type Design, toTargets } from "../design/design.ts";
import { fromDesign } from "../design/design-value.ts";
import * as steps from "../design/history.ts";
import type { Steps } from "../design/recipe.ts";
import { symmetryIn } from "../design/symmetry.ts";
import type { Unit } from "../quantity/units.ts";
import { done, type Refusal, type Result, refuse } from "../result/result.ts";
import type { Context } from "../rhino/context.ts";
import { FILE_FORMATS, namesOfFormats } from "../solver/file-formats.ts";
import type { DesignReading, OpenedMesh, Source, StoredDesign } from "../solver/protocol.ts";
import { enqueue, type Outcome } from "./action-queue.ts";
import { baseOf, openQuestion, run } from "./connection.ts";
import { readText } from "./design-text.ts";
import { distance, formatSmall, isRounding } from "./deviating.ts";
import { adopt, freshDesign } from "./opening.ts";
import type { Page } from "./page.ts";
import { compute, differingIn, replayNow, sizeOf } from "./replaying.ts";
import { restorePresent, takeMesh } from "./showing.ts";

function finish(page: Page, design: Design, said: string): void {
  page.draft.value = design;
  page.history.value = page.history.value
    ? steps.record(page.history.value, design)
    : steps.begin(design);
  page.notice.value = said;
}

/** The stored shape itself, with as much of its recipe as is known. */
async function asStored(page: Page, design: Design, { shape }: StoredDesign, why: string): Outcome {
  const { handles, settings, variation } = design;
  const targets = toTargets(handles);
  const keep = variation !== null;
  const answer = await run(
    page,
    "opening the design",
    { kind: "restore", targets, settings, shape, keep },
    "shown",
  );
  if (!answer.ok) return answer;
  const report = { ...design.report, ...answer.value.report };
  finish(page, { ...design, shape, report }, `Opened as it was stored. ${why}`);
  return answer;
}

const NOT_UNCUT = "It does not hold the mesh before its cuts: they cannot be removed.";

/** The base of a recipe opened again, where what was read from a GLB is not all of it; else null.
 * @param source what was read  @param isUncut the recipe's own is the mesh before its cuts */
async function rebase(
  page: Page,
  recipe: Steps,
  source: Source,
  isUncut: boolean,
): Promise<Result<OpenedMesh | null>> {
  const symmetry = symmetryIn(recipe.settings);
  // What was read has no symmetry yet; without it edits would have no images.
  if (!symmetry && !isUncut) return done(null);
  const flat = { source, planarised: null, symmetry, cuts: [] };
  const question = openQuestion(isUncut ? baseOf(recipe) : flat);
  const again = await run(page, "opening the design", question, "opened");
  return again.ok ? done(again.value.mesh) : again;
}

/** Does the stored recipe again; where that gives another shape today, the stored one counts. */
async function reopen(
  page: Page,
  source: Source,
  opened: OpenedMesh,
  stored: StoredDesign,
  reading: DesignReading,
): Outcome {
  const text = fromDesign(reading);
  const uncut = text.ok && text.value.settings.cuts.length > 0 ? text.value.source : null;
  const lacking = text.ok && text.value.settings.cuts.length > 0 && !uncut;
  if (!text.ok || lacking) {
    const plain = freshDesign(page, source, null, opened);
    takeMesh(page, plain, opened);
    return asStored(page, plain, stored, text.ok ? NOT_UNCUT : text.reason);
  }
  // The base in the file is that of the design, whatever became of where it came from; where it is what
  // cuts left, the design has the mesh before them.
  const sample = text.value.source?.kind === "sample" ? text.value.source : null;
  const from = uncut ?? sample ?? source;
  const recipe: Steps = { ...text.value, source: from, baseHash: null, camera: null };
  const rebased = await rebase(page, recipe, source, uncut !== null);
  if (!rebased.ok) return restorePresent(page, rebased);
  const base = rebased.value ?? opened;
  const end = await compute(page, recipe, base);
  page.unit.value = recipe.unit;
  const off = end.ok ? distance(end.value.design.shape, stored.shape, opened.positions) : null;
  if (end.ok && off === 0) {
    finish(page, end.value.design, VERIFIED);
    return end;
  }
  const size = sizeOf(opened.report);
  const rounding = off !== null && isRounding(off, size, recipe.unit);
  const differs = off === null ? "It cannot be computed again here." : differing(off, recipe.unit);
  if (end.ok && rounding) return asStored(page, end.value.design, stored, `${differs}: rounding.`);
  const { planarised, handles, settings } = recipe;
  const fresh = { ...freshDesign(page, recipe.source, planarised, opened), handles, settings };
  return asStored(page, fresh, stored, off === null ? differs : `${differs}.`);
}

const VERIFIED = "Verified: the same result as when it was stored, to the last bit.";

const differing = (off: number, of: Unit): string =>
  `Recomputed here it differs by up to ${formatSmall(off, of)}`;

/** Characters. */
const LONGEST_DESIGN = 64 * 2 ** 20;

/** A design as text: done again, or what is wrong with it. */
async function openDesign(page: Page, file: File): Promise<Result<unknown>> {
  const wrong = (reason: string): Refusal => refuse(`${file.name}: ${reason}`);
  if (file.size > LONGEST_DESIGN) return wrong("A design has at most 64 MB.");
  const text = await file.text().catch(() => null);
  if (text === null) return wrong("It could not be read. Open it again.");
  const read = await readText(page, `reading ${file.name}`, text);
  if (!read.ok) return read.reason ? wrong(read.reason) : read;
  const { source, meshName } = read.value;
  if (!source)
    return wrong(`Its mesh, ${meshName.slice(0, 100)}, lies beside it. Open it as a GLB instead.`);
  const opened = await replayNow(page, { ...read.value, source });
  return opened.ok || !opened.reason ? differingIn(opened) : wrong(opened.reason);
}

function keepContext(page: Page, source: Source, context: Context | null): void {
  if (context) page.contexts.value = new Map([...page.contexts.value, [source, context]]);
  page.contextHidden.value = false;
}

/** A design again, or a mesh with what was done to it and what was left out. */
async function openModel(page: Page, file: File): Outcome {
  const { name } = file;
  const answer = await run(page, `reading ${name}`, { kind: "unpack", file, name }, "unpacked");
  if (!answer.ok) return answer;
  const { mesh, design, unit: unitOfFile, context, remarks } = answer.value.model;
  if (design) {
    const before = page.draft.value;
    const end = await openDesign(page, new File([design], name));
    if (page.draft.value && page.draft.value !== before)
      keepContext(page, page.draft.value.source, context);
    return end;
  }
  const read = { kind: "read", file: new Blob([mesh as BlobPart]), name, format: "obj" } as const;
  const opened = await run(page, `reading ${name}`, read, "opened");
  if (!opened.ok || !opened.value.source) return opened;
  const { source, mesh: base } = opened.value;
  const warnings = [...remarks, ...base.report.warnings];
  adopt(page, source, null, { ...base, report: { ...base.report, warnings } });
  keepContext(page, source, context);
  if (unitOfFile) page.unit.value = unitOfFile;
  page.importReport.value = true;
  return opened;
}

const extensionOf = (name: string): string => name.split(".").at(-1)?.toLowerCase() ?? "";

async function openNow(page: Page, file: File): Outcome {
  const { name } = file;
  const extension = extensionOf(name);
  if (extension === "json") return openDesign(page, file);
  if (extension === "3dm") return openModel(page, file);
  const format = FILE_FORMATS.find((f) => f === extension);
  if (!format)
    return refuse(
      `${name} cannot be read. Use an ${namesOfFormats("3dm")} file, or a design (JSON).`,
    );
  const question = { kind: "read", file, name, format } as const;
  const answer = await run(page, `reading ${name}`, question, "opened");
  if (!answer.ok || !answer.value.source) return answer;
  const { stored, source, mesh } = answer.value;
  if (stored?.design) return reopen(page, source, mesh, stored, stored.design);
  adopt(page, source, null, mesh);
  page.importReport.value = true;
  return answer;
}

export const openFile = (page: Page, file: File): Outcome =>
  enqueue(page, () => {
    // It was of what was open before, also where this file is refused.
    page.notice.value = null;
    return openNow(page, file);
  });
