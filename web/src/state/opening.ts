// SPDX-License-Identifier: MIT
// Opening samples, planarising what is not flat. Each is one step of the history.

import {
  type Design,
  FIRST_SETTINGS,
  NO_REPORT,
  NO_SHAPE,
  settingsForNew,
  sourceName,
} from "../design/design.ts";
import * as steps from "../design/history.ts";
import { isKeptBy, type Kind, kindOf, withKind } from "../design/kept-kind.ts";
import { FAIR_FLAT, sameWay, type Trial } from "../design/planarising.ts";
import { FIRST_SAMPLE, SAMPLES } from "../design/samples.ts";
import { counted } from "../quantity/counted.ts";
import { done, GIVEN_UP, type Refusal, type Result } from "../result/result.ts";
import { isFound } from "../solver/found-limits.ts";
import type { MeshReport, OpenedMesh, Planarising, Source } from "../solver/protocol.ts";
import { enqueue, type Outcome } from "./action-queue.ts";
import { openQuestion, run } from "./connection.ts";
import { commitEdit } from "./editing.ts";
import type { Page } from "./page.ts";
import { firstReach } from "./reach-choice.ts";
import { sensibleVertex } from "./sensible-vertex.ts";
import { restorePresent, takeMesh } from "./showing.ts";

/** A tolerance that one mesh asked for is no choice for another. */
const toleranceFor = (page: Page, source: Source, tolerance: number): number =>
  page.draft.value?.source === source || !page.toleranceTaken.value
    ? tolerance
    : FIRST_SETTINGS.tolerance;

/** A limit on folds that the page found for the edit of one mesh is no choice for another. */
function limitsFor(page: Page, source: Source, limits: readonly string[]): readonly string[] {
  if (page.draft.value?.source === source) return limits;
  const stated = page.statedLimits.value;
  return limits.filter((limit) => !isFound(limit, stated));
}

/** The unedited mesh as a design. @param cuts what was made of it before it was opened so */
export function freshDesign(
  page: Page,
  source: Source,
  planarised: Planarising | null,
  opened: OpenedMesh,
  cuts: readonly string[] = [],
): Design {
  const { worstGap, worstMmPerM, worstExcess } = opened.report;
  const shown = settingsForNew(page.settings.value ?? FIRST_SETTINGS);
  const tolerance = toleranceFor(page, source, shown.tolerance);
  // A kind that the mesh does not keep would refuse every edit.
  const constraints = shown.constraints.filter((kept) => {
    const kind = kindOf(kept);
    return kind !== undefined && isKeptBy(opened.report, kind);
  });
  return {
    source,
    planarised,
    handles: [],
    settings: {
      ...firstReach(page, shown),
      tolerance,
      constraints,
      cuts,
      limits: limitsFor(page, source, shown.limits),
    },
    shape: NO_SHAPE,
    report: { ...NO_REPORT, worstGap, worstMmPerM, worstExcess },
    variation: null,
  };
}

const LIMITS_STAY = "The limits set for the mesh before apply here, too: see Limits.";

/** Shows what the solver has opened, as one more step of the history. */
export function adopt(
  page: Page,
  source: Source,
  planarised: Planarising | null,
  opened: OpenedMesh,
  cuts: readonly string[] = [],
): void {
  const design = freshDesign(page, source, planarised, opened, cuts);
  const before = page.draft.peek()?.source ?? source;
  const stay = before !== source && design.settings.limits.length > 0;
  takeMesh(page, design, opened);
  page.notice.value = stay ? LIMITS_STAY : null;
  page.history.value = page.history.value
    ? steps.record(page.history.value, design)
    : steps.begin(design);
}

export const openSample = (page: Page, name: string): Outcome =>
  enqueue(page, async () => {
    const sample = SAMPLES.find((s) => s.name === name);
    if (!sample) return;
    const source: Source = { kind: "sample", name, size: sample.size };
    const question = openQuestion({ source, planarised: null, symmetry: null, cuts: [] });
    const answer = await run(page, `opening ${sample.label}`, question, "opened");
    if (!answer.ok) return restorePresent(page, answer);
    adopt(page, source, null, answer.value.mesh);
    return answer;
  });

const NOT_FLAT =
  "Some panels cannot become flat and keep their shape. Fairer reaches further; the nearest flat mesh comes without “Panels keep their shape” under Advanced.";

const SYMMETRY_OFF =
  "Edits follow no symmetry any more: the flat mesh is another one. Choose it again under Symmetry.";

/** What the mesh became is not what was asked for; "" where it is. */
function missed(page: Page, asked: readonly string[], report: MeshReport): string {
  if (!page.baseFlat.value) return NOT_FLAT;
  const kinds = asked.map(kindOf).filter((kind) => kind && !isKeptBy(report, kind));
  return kinds.length > 0
    ? `The mesh cannot become ${kinds.join(" and ")} and keep its shape.`
    : "";
}

/** What was made of the mesh that is open, read as a file of its own. */
export async function readMade(
  page: Page,
  label: string,
  name: string,
  bytes: Uint8Array,
): Promise<Result<{ readonly source: Source; readonly mesh: OpenedMesh }>> {
  const file = new Blob([bytes as BlobPart]);
  const read = await run(page, label, { kind: "read", file, name, format: "obj" }, "opened");
  if (!read.ok) return restorePresent(page, read);
  const { source, mesh } = read.value;
  return source ? done({ source, mesh }) : restorePresent(page, GIVEN_UP);
}

/** "roof.obj", "roof, split.obj" */
const splitName = (name: string): string => `${name.replace(/\.[a-z]{3}$/i, "")}, split.obj`;

/** Panels are split before the mesh is made flat, where a recipe has no cuts: the mesh becomes a file of
 * its own, one step of the history. */
async function takeSplit(page: Page, { how, split }: Trial): Outcome {
  const design = page.draft.value;
  if (!design || !split) return;
  const name = splitName(sourceName(design.source));
  const read = await readMade(page, "splitting panels", name, split.file);
  if (!read.ok) return read;
  const { settings } = design;
  const tolerance = Math.max(settings.tolerance, how.flat);
  page.draft.value = { ...design, settings: { ...settings, tolerance } };
  adopt(page, read.value.source, null, read.value.mesh);
  const panels = counted(split.panels, "panel");
  page.notice.value = page.baseFlat.value
    ? `${panels} split, and every panel is flat. Edits start from this mesh; Undo brings the file back.`
    : NOT_FLAT;
  return read;
}

interface Planarised {
  readonly how: Planarising;
  readonly answer: Result<{ readonly mesh: OpenedMesh }>;
  /** Why another try, which would have been better, was refused. */
  readonly refused?: Refusal;
}

/** Makes a mesh flat. Where it cannot become of a kind with its boundary kept, the boundary moves too. */
async function flatMesh(
  page: Page,
  how: Planarising,
  found: Float64Array | null,
  kind: Kind | undefined,
): Promise<Planarised> {
  const doing = kind ? `making the mesh ${kind}` : "making every panel flat";
  const ask = (way: Planarising, from: Float64Array | null) =>
    run(page, doing, { kind: "planarise", how: way, found: from }, "opened");
  const answer = await ask(how, found);
  const missed = answer.ok ? kind && !isKeptBy(answer.value.mesh.report, kind) : answer.reason;
  if (!kind || !how.keepBoundary || !missed) return { how, answer };
  const free = { ...how, keepBoundary: false };
  const freed = await ask(free, null);
  if (freed.ok) return { how: free, answer: freed };
  return freed.reason ? { how, answer, refused: freed } : { how, answer };
}

/**
 * Makes the mesh flat; within a queued action. An edit that asked for that is done again on it, as one more step.
 * @param kind what it becomes beside flat and what is kept already
 * @param trial what was tried out; taken as it is where it is what is wanted
 */
export async function planariseNow(page: Page, kind?: Kind, trial?: Trial): Outcome {
  const design = page.draft.value;
  if (!design) return;
  const { handles, settings } = design;
  const tolerance = page.refusedTolerance.value ?? settings.tolerance;
  const constraints = kind ? withKind(settings.constraints, kind) : settings.constraints;
  // What was chosen at a door is not seen where a mesh is flat.
  const wish = trial?.instead ? trial.how : page.planarising.value;
  const chosen = kind && page.baseFlat.value ? FAIR_FLAT : wish;
  const asked = { ...chosen, keepShape: settings.keepShape, constraints };
  // What a trial found of a mesh with cuts has their points, too.
  const usable = trial && settings.cuts.length === 0 && sameWay(trial.how, asked);
  const found = usable ? trial.mesh.positions : null;
  const { how, answer, refused } = await flatMesh(page, asked, found, kind);
  if (!answer.ok) return refused ?? answer;
  const { mesh } = answer.value;
  // An edit cannot be flatter than its mesh.
  const met = Math.max(tolerance, how.flat);
  if (met > tolerance) page.toleranceTaken.value = true;
  page.draft.value = { ...design, settings: { ...settings, tolerance: met, constraints } };
  adopt(page, design.source, how, mesh, settings.cuts);
  const asymmetric = settings.symmetry.length > 0 && !mesh.symmetry;
  const words = missed(page, constraints, mesh.report) || (asymmetric ? SYMMETRY_OFF : "");
  if (words) page.notice.value = words;
  const again = handles.length > 0 && page.baseFlat.value;
  const edited = again && (await commitEdit(page, { ...page.draft.value, handles }, "solve"));
  return edited || (refused ?? answer);
}

/** What is tried out is what is taken, as soon as it is there. */
export function planarise(page: Page): Outcome {
  const tried = page.planariseTrial.peek();
  return enqueue(page, async () => {
    if (tried.kind !== "shown" && tried.kind !== "running") return planariseNow(page);
    const trial = tried.kind === "shown" ? tried.trial : await tried.done;
    if (!trial) return;
    return trial.split ? takeSplit(page, trial) : planariseNow(page, undefined, trial);
  });
}

/** Makes the mesh itself circular or conical, which its edits then keep. */
export const makeKept = (page: Page, kind: Kind): Outcome =>
  enqueue(page, () => planariseNow(page, kind));

/** The first visit: the painted sample becomes live, and one point asks to be dragged. */
export async function openFirst(page: Page): Promise<void> {
  await openSample(page, FIRST_SAMPLE.name);
  const opened = page.mesh.value;
  if (!opened) return;
  page.hintVertex.value = sensibleVertex(opened.display, opened.topology.boundary, []);
}
