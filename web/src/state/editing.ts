// SPDX-License-Identifier: MIT
// Every way to change an edit. Each ends as one step of the history.

import type { Question } from "../solver/client.ts";
import type { EditMode, EditSettings } from "../solver/protocol.ts";
import { announceChanges, client, frame, run } from "./connection.ts";
import {
  type Design,
  type HandleRow,
  NO_SHAPE,
  type Point,
  toTargets,
  withHandle,
  withoutHandle,
} from "./design.ts";
import * as steps from "./history.ts";
import { sensibleVertex } from "./sensible-vertex.ts";
import { draft, figures, hintVertex, history, mesh, notice, problem, selected } from "./store.ts";

/** A drag frame may take this long; what it has then is exact, if not yet optimal. */
const FRAME_SECONDS = 0.016;

export function basePoint(vertex: number): Point {
  const p = mesh.value?.positions;
  return [p?.[3 * vertex] ?? 0, p?.[3 * vertex + 1] ?? 0, p?.[3 * vertex + 2] ?? 0];
}

export const handleOf = (vertex: number): HandleRow | undefined =>
  draft.value?.handles.find((row) => row.vertex === vertex);

function question(design: Design, mode: EditMode): Question {
  const targets = toTargets(design.handles);
  if (targets.handles.length === 0) return { kind: "restore", targets, shape: NO_SHAPE };
  return { kind: "edit", mode, targets, settings: design.settings, budget: FRAME_SECONDS };
}

/** Computes `next` and records it; a failure keeps the last design, on screen and in the solver. */
export async function commit(next: Design, ask: Question, label: string): Promise<void> {
  draft.value = next;
  notice.value = null;
  const answer = await run(label, ask, "shown");
  const steady = history.value;
  if (!steady) return;
  if (!answer?.shape) {
    await show(steady.present);
    return;
  }
  const done: Design = { ...next, shape: answer.shape, report: answer.report };
  history.value = steps.record(steady, done);
  if (draft.value === next) draft.value = done;
}

export const commitEdit = (next: Design, mode: EditMode): Promise<void> =>
  commit({ ...next, variation: null }, question(next, mode), "computing");

/** Puts a known design back, without solving. */
async function show(design: Design): Promise<void> {
  const kept = problem.value;
  draft.value = design;
  const targets = toTargets(design.handles);
  await run("restoring", { kind: "restore", targets, shape: design.shape }, "shown");
  figures.value = design.report;
  problem.value = kept;
}

function changed(rows: readonly HandleRow[]): Design | null {
  return draft.value ? { ...draft.value, handles: rows } : null;
}

export function dragHandle(vertex: number, target: Point): void {
  const next = changed(withHandle(draft.value?.handles ?? [], { vertex, target, pinned: false }));
  if (!next) return;
  hintVertex.value = null;
  draft.value = next;
  void frame(question(next, "drag"));
}

export async function endDrag(): Promise<void> {
  client.dropStreams();
  if (draft.value && draft.value !== history.value?.present)
    await commitEdit(draft.value, "release");
}

/** Escape during a drag. */
export async function abandonDrag(): Promise<void> {
  client.dropStreams();
  if (history.value) await show(history.value.present);
}

export async function setTarget(vertex: number, target: Point): Promise<void> {
  const next = changed(withHandle(draft.value?.handles ?? [], { vertex, target, pinned: false }));
  hintVertex.value = null;
  if (next) await commitEdit(next, "solve");
}

export async function setPinned(vertex: number, pinned: boolean): Promise<void> {
  const target = handleOf(vertex)?.target ?? basePoint(vertex);
  const next = changed(withHandle(draft.value?.handles ?? [], { vertex, target, pinned }));
  if (next) await commitEdit(next, "solve");
}

/** Adds the selected point, or a sensible one. */
export async function addHandle(): Promise<void> {
  const opened = mesh.value;
  if (!opened) return;
  const taken = draft.value?.handles.map((row) => row.vertex) ?? [];
  const chosen =
    selected.value !== null && !taken.includes(selected.value)
      ? selected.value
      : sensibleVertex(opened.display, opened.topology.boundary, taken);
  if (chosen === null) return;
  selected.value = chosen;
  await setTarget(chosen, shownPoint(chosen));
}

/** Where the design has a vertex now, model units. */
export function shownPoint(vertex: number): Point {
  const shape = draft.value?.shape ?? NO_SHAPE;
  const k = shape.moved.indexOf(vertex);
  if (k < 0) return basePoint(vertex);
  const p = shape.positions;
  return [p[3 * k] ?? 0, p[3 * k + 1] ?? 0, p[3 * k + 2] ?? 0];
}

export async function removeHandle(vertex: number): Promise<void> {
  const next = changed(withoutHandle(draft.value?.handles ?? [], vertex));
  if (next) await commitEdit(next, "solve");
}

/** While a weight's slider moves. */
export function previewSettings(change: Partial<EditSettings>): void {
  if (!draft.value) return;
  const next = { ...draft.value, settings: { ...draft.value.settings, ...change } };
  draft.value = next;
  if (next.handles.length > 0) void frame(question(next, "drag"));
}

export async function commitSettings(change: Partial<EditSettings>): Promise<void> {
  if (!draft.value) return;
  client.dropStreams();
  await commitEdit({ ...draft.value, settings: { ...draft.value.settings, ...change } }, "solve");
}

async function step(move: typeof steps.undo<Design>): Promise<void> {
  if (!history.value) return;
  const moved = move(history.value);
  if (moved === history.value) return;
  client.dropStreams();
  history.value = moved;
  await show(moved.present);
}

export const undo = (): Promise<void> => step(steps.undo);
export const redo = (): Promise<void> => step(steps.redo);

/** Stops whatever runs and puts the last finished design back at once. */
export async function cancel(): Promise<void> {
  client.cancel();
  const design = history.value?.present;
  const opened = mesh.value;
  if (!design || !opened) return;
  draft.value = design;
  figures.value = design.report;
  announceChanges(displayOf(design));
  const { source, planarised } = design;
  await run("restarting the solver", { kind: "open", source, planarise: planarised }, "opened");
  await show(design);
}

/** The whole design in display coordinates, from what the page itself keeps. */
function displayOf(design: Design): Float32Array {
  const opened = mesh.value;
  if (!opened) return new Float32Array(0);
  const { centre, scale } = opened.report;
  const { display } = opened;
  const all = new Float32Array((display.length / 3) * 4);
  for (let v = 0; v < display.length / 3; ++v) {
    all.set([v, display[3 * v] ?? 0, display[3 * v + 1] ?? 0, display[3 * v + 2] ?? 0], 4 * v);
  }
  const { moved, positions } = design.shape;
  moved.forEach((v, k) => {
    const at = (axis: 0 | 1 | 2) => ((positions[3 * k + axis] ?? 0) - centre[axis]) * scale;
    all.set([v, at(0), at(1), at(2)], 4 * v);
  });
  return all;
}
