// SPDX-License-Identifier: MIT
// Opening samples, planarising what is not flat. Each is one step of the history.
import type { MeshReport, OpenedMesh, Planarising, Source } from "../solver/protocol.ts";
import { run } from "./connection.ts";
import { type Design, FIRST_SETTINGS, NO_REPORT, NO_SHAPE, settingsForNew } from "./design.ts";
import { commitEdit } from "./editing.ts";
import * as steps from "./history.ts";
import { isKeptBy, type Kind, kindOf, withKind } from "./kept-kind.ts";
import { FAIR_FLAT, sameWay, type Trial } from "./planarising.ts";
import { FIRST_SAMPLE, SAMPLES } from "./samples.ts";
import { sensibleVertex } from "./sensible-vertex.ts";
import { showPresent, takeMesh } from "./showing.ts";
import {
  baseFlat,
  draft,
  hintVertex,
  history,
  mesh,
  notice,
  planariseTrial,
  planarising,
  problem,
  refusedTolerance,
  settings,
} from "./store.ts";
import { inTurn } from "./turns.ts";

/** The unedited mesh as a design. */
export function freshDesign(
  source: Source,
  planarised: Planarising | null,
  opened: OpenedMesh,
): Design {
  const { worstGap, worstMmPerM, worstExcess } = opened.report;
  const shown = settingsForNew(settings.value ?? FIRST_SETTINGS);
  // A kind that the mesh does not keep would refuse every edit.
  const constraints = shown.constraints.filter((kept) => {
    const kind = kindOf(kept);
    return kind !== undefined && isKeptBy(opened.report, kind);
  });
  return {
    source,
    planarised,
    handles: [],
    settings: { ...shown, constraints },
    shape: NO_SHAPE,
    report: { ...NO_REPORT, worstGap, worstMmPerM, worstExcess },
    variation: null,
  };
}

/** Shows what the solver has opened, as one more step of the history. */
export function adopt(source: Source, planarised: Planarising | null, opened: OpenedMesh): void {
  const design = freshDesign(source, planarised, opened);
  takeMesh(design, opened);
  notice.value = null;
  history.value = history.value ? steps.record(history.value, design) : steps.begin(design);
}

export const openSample = (name: string): Promise<void> =>
  inTurn(async () => {
    const sample = SAMPLES.find((s) => s.name === name);
    if (!sample) return;
    const source: Source = { kind: "sample", name, size: sample.size };
    const question = { kind: "open", source, planarise: null } as const;
    const answer = await run(`opening ${sample.label}`, question, "opened");
    if (answer) adopt(source, null, answer.mesh);
    else await showPresent();
  });

const NOT_FLAT =
  "Some panels cannot become flat and keep their shape. Fairer reaches further; the nearest flat mesh comes without “Panels keep their shape” under Advanced.";

/** What the mesh became is not what was asked for; "" where it is. */
function missed(asked: readonly string[], report: MeshReport): string {
  if (!baseFlat.value) return NOT_FLAT;
  const kinds = asked.map(kindOf).filter((kind) => kind && !isKeptBy(report, kind));
  return kinds.length > 0
    ? `The mesh cannot become ${kinds.join(" and ")} and keep its shape.`
    : "";
}

/**
 * Within a turn. An edit that asked for a flatter mesh is done again on it, as one more step. Where a mesh
 * cannot become of a kind with its boundary kept, the boundary moves too.
 * @param kind what it becomes beside flat and what is kept already
 * @param trial what was tried out; taken as it is where it is what is wanted
 */
export async function planariseNow(kind?: Kind, trial?: Trial): Promise<void> {
  const design = draft.value;
  if (!design) return;
  const { handles, settings } = design;
  const tolerance = refusedTolerance.value ?? settings.tolerance;
  const constraints = kind ? withKind(settings.constraints, kind) : settings.constraints;
  // What was chosen at a door is not seen where a mesh is flat.
  const chosen = kind && baseFlat.value ? FAIR_FLAT : planarising.value;
  let how = { ...chosen, keepShape: settings.keepShape, constraints };
  const found = trial && sameWay(trial.how, how) ? trial.mesh.positions : null;
  const doing = kind ? `making the mesh ${kind}` : "making every panel flat";
  problem.value = null;
  let answer = await run(doing, { kind: "planarise", how, found }, "opened");
  // A refusal has been said; what was given up has not.
  const missesKind = answer ? kind && !isKeptBy(answer.mesh.report, kind) : problem.value !== null;
  if (kind && how.keepBoundary && missesKind) {
    const free = { ...how, keepBoundary: false };
    const freed = await run(doing, { kind: "planarise", how: free, found: null }, "opened");
    if (freed) [how, answer] = [free, freed];
  }
  if (!answer) return;
  // An edit cannot be flatter than its mesh.
  const met = Math.max(tolerance, how.flat);
  draft.value = { ...design, settings: { ...settings, tolerance: met, constraints } };
  adopt(design.source, how, answer.mesh);
  const words = missed(constraints, answer.mesh.report);
  if (words) notice.value = words;
  if (handles.length > 0 && baseFlat.value) await commitEdit({ ...draft.value, handles }, "solve");
}

/** What is tried out is what is taken, as soon as it is there. */
export function planarise(): Promise<void> {
  const tried = planariseTrial.peek();
  return inTurn(async () => {
    if (tried.kind === "shown") return planariseNow(undefined, tried.trial);
    if (tried.kind !== "running") return planariseNow();
    const trial = await tried.done;
    if (trial) await planariseNow(undefined, trial);
  });
}

/** Makes the mesh itself circular or conical, which its edits then keep. */
export const makeKept = (kind: Kind): Promise<void> => inTurn(() => planariseNow(kind));

/** The first visit: the painted sample becomes live, and one point asks to be dragged. */
export async function openFirst(): Promise<void> {
  await openSample(FIRST_SAMPLE.name);
  const opened = mesh.value;
  if (!opened) return;
  hintVertex.value = sensibleVertex(opened.display, opened.topology.boundary, []);
}
