// SPDX-License-Identifier: MIT
// Every way to change an edit. Each ends as one step of the history.

import type { Question } from "../solver/client.ts";
import { FAIR_STEPS, foldGrowth } from "../solver/fair-folds.ts";
import type { EditMode, EditSettings, ShapeReport } from "../solver/protocol.ts";
import type { PullLimit } from "../solver/pull-limit.ts";
import { client, frame, run } from "./connection.ts";
import {
  type Design,
  type HandleRow,
  leftBehind,
  NO_SHAPE,
  type Point,
  toTargets,
  withHandle,
  withoutHandle,
  withTaken,
} from "./design.ts";
import * as steps from "./history.ts";
import { selectOnly } from "./selection.ts";
import { sensibleVertex } from "./sensible-vertex.ts";
import { show, showPresent } from "./showing.ts";
import { limitNumbers } from "./stated-limit.ts";
import {
  draft,
  figures,
  hintVertex,
  history,
  mesh,
  notice,
  refusedTolerance,
  selected,
} from "./store.ts";
import { inTurn } from "./turns.ts";

/** A drag frame may take this long; what it has then is exact, if not yet optimal. */
const FRAME_SECONDS = 0.016;

export function basePoint(vertex: number): Point {
  const p = mesh.value?.positions;
  return [p?.[3 * vertex] ?? 0, p?.[3 * vertex + 1] ?? 0, p?.[3 * vertex + 2] ?? 0];
}

export const handleOf = (vertex: number): HandleRow | undefined =>
  draft.value?.handles.find((row) => row.vertex === vertex);

/** What makes the solver compute the edit of `design`. */
export function editQuestion(
  design: Design,
  mode: EditMode,
  limit: PullLimit | null = null,
  fairWay: number | null = null,
): Question {
  const targets = toTargets(design.handles);
  if (targets.handles.length === 0)
    return { kind: "restore", targets, settings: design.settings, shape: NO_SHAPE, keep: false };
  const { settings } = design;
  return { kind: "edit", mode, targets, settings, budget: FRAME_SECONDS, limit, fairWay };
}

/** Whether folds are kept fair without being asked: not by raw weights, nor where they are free to be
 * sharp, by a limit of their own or by what is shown already. */
function wantsFairFolds({ settings }: Design): boolean {
  const { softness, hardHandles, limits } = settings;
  const own = limits.some((limit) => limit.startsWith("fold="));
  const sharp = foldGrowth(figures.value) > (FAIR_STEPS[0] ?? 0);
  return softness > 0 && !hardHandles && !own && !sharp;
}

/** Of the handle that goes furthest, model units; null where folds are as they come. */
function fairWayOf(design: Design): number | null {
  if (!wantsFairFolds(design)) return null;
  const ways = design.handles
    .filter(({ pinned }) => !pinned)
    .map(({ vertex, target }) => {
      const from = basePoint(vertex);
      return Math.hypot(...target.map((x, axis) => x - (from[axis] ?? 0)));
    });
  return Math.max(0, ...ways);
}

/** The last burst of keys on a slider and what it gave. */
let latest: { readonly burst: string; readonly design: Design } | null = null;

/** Keys on a slider, one after the other, are one step of the history. */
function recordStep(steady: steps.History<Design>, done: Design, burst: string | null): void {
  const goesOn = goesOnFrom(steady.present, burst);
  history.value = goesOn ? steps.amend(steady, done) : steps.record(steady, done);
  latest = burst === null ? null : { burst, design: done };
}

const goesOnFrom = (design: Design | undefined, burst: string | null): boolean =>
  burst !== null && latest?.burst === burst && latest.design === design;

/**
 * Computes `next` and records it; a failure keeps the last design, on screen and in the solver.
 * @param burst names the keys on a slider that it is one of
 */
export async function commit(
  next: Design,
  ask: Question,
  label: string,
  burst: string | null = null,
): Promise<void> {
  draft.value = next;
  if (!goesOnFrom(history.value?.present, burst)) notice.value = null;
  const answer = await run(label, ask, "shown");
  const steady = history.value;
  if (!steady) return;
  if (!answer?.shape) {
    await showPresent();
    return;
  }
  const handles = answer.taken ? withTaken(next.handles, answer.taken) : next.handles;
  const { shape, report } = answer;
  const { stated } = answer;
  const limits = stated ? [...next.settings.limits, stated] : next.settings.limits;
  const settings = { ...next.settings, limits, continuation: continuationOf(ask, report, next) };
  const done: Design = { ...next, handles, settings, shape, report };
  recordStep(steady, done, burst);
  if (draft.value === next) draft.value = done;
  if (stated) notice.value = keptFair(stated);
  if (leftBehind(steady.present) && !done.variation) notice.value = LEFT_BEHIND;
}

/** The steps that an edit took; a variation of it leaves them as they are. */
function continuationOf(ask: Question, report: ShapeReport, { settings }: Design): number {
  if (ask.kind === "edit") return report.continuation ?? 0;
  return ask.kind === "restore" ? 0 : settings.continuation;
}

const keptFair = (limit: string): string =>
  `Folds are kept to ${limitNumbers(limit)[0]}° sharper than they were. To let them go, use Limits.`;

const LEFT_BEHIND =
  "The variation was left behind: Undo brings it back. To keep it, use Continue from this shape first.";

/** An edit starts from the base: a variation of the edit before it does not belong to it. */
export const commitEdit = (
  next: Design,
  mode: EditMode,
  burst: string | null = null,
  limit: PullLimit | null = null,
): Promise<void> =>
  commit({ ...next, variation: null }, editQuestion(next, mode, limit), "computing", burst);

function changed(rows: readonly HandleRow[]): Design | null {
  return draft.value ? { ...draft.value, handles: rows } : null;
}

/** One edit of the handles as they are when its turn comes. */
export const edit = (
  change: (rows: readonly HandleRow[]) => HandleRow[],
  burst: string | null = null,
): Promise<void> =>
  inTurn(async () => {
    const next = changed(change(draft.value?.handles ?? []));
    if (!next) return;
    const asked = { ...next, variation: null };
    await commit(asked, editQuestion(asked, "solve", null, fairWayOf(asked)), "computing", burst);
  }, burst);

export async function setTarget(
  vertex: number,
  target: Point,
  burst: string | null = null,
): Promise<void> {
  hintVertex.value = null;
  await edit((rows) => withHandle(rows, { vertex, target, pinned: false }), burst);
}

/** Pins points to where the base has them, or lets them go. */
export const setPinned = (vertices: readonly number[], pinned: boolean): Promise<void> =>
  edit((rows) => {
    let next = [...rows];
    for (const vertex of vertices) {
      const target = handleOf(vertex)?.target ?? basePoint(vertex);
      next = withHandle(next, { vertex, target, pinned });
    }
    return next;
  });

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
  selectOnly(chosen);
  await setTarget(chosen, shownPoint(chosen));
}

/** Where the design, or another shape of its mesh, has a vertex; model units. */
export function shownPoint(vertex: number, shape = draft.value?.shape ?? NO_SHAPE): Point {
  const k = shape.moved.indexOf(vertex);
  if (k < 0) return basePoint(vertex);
  const p = shape.positions;
  return [p[3 * k] ?? 0, p[3 * k + 1] ?? 0, p[3 * k + 2] ?? 0];
}

export const removeHandle = (vertex: number): Promise<void> =>
  edit((rows) => withoutHandle(rows, vertex));

export function removeHandles(vertices: readonly number[]): Promise<void> {
  const gone = new Set(vertices);
  return edit((rows) => rows.filter((row) => !gone.has(row.vertex)));
}

/** Lets pinned points go: those that were to go somewhere go there again, the others are no handles. */
export function freePins(vertices: readonly number[]): Promise<void> {
  const freed = new Set(vertices);
  const stays = ({ vertex, target }: HandleRow): boolean =>
    basePoint(vertex).every((x, axis) => x === target[axis]);
  return edit((rows) =>
    rows.flatMap((row) => {
      if (!row.pinned || !freed.has(row.vertex)) return [row];
      return stays(row) ? [] : [{ ...row, pinned: false }];
    }),
  );
}

/** While a weight's slider moves. */
export function previewSettings(change: Partial<EditSettings>): void {
  if (!draft.value) return;
  const next = { ...draft.value, settings: { ...draft.value.settings, ...change } };
  draft.value = next;
  if (next.handles.length > 0) void frame(editQuestion(next, "drag"));
}

/** An edit cannot be flatter than what it does not move; without one the tolerance is only noted. */
const needsFlatterMesh = ({ handles, settings }: Design): boolean =>
  toTargets(handles).handles.length > 0 &&
  (mesh.value?.report.worstExcess ?? 0) > settings.tolerance;

export async function commitSettings(
  change: Partial<EditSettings>,
  burst: string | null = null,
): Promise<void> {
  client.dropStreams();
  await inTurn(async () => {
    const design = draft.value;
    if (!design) return;
    const next = { ...design, settings: { ...design.settings, ...change } };
    refusedTolerance.value = needsFlatterMesh(next) ? next.settings.tolerance : null;
    if (refusedTolerance.value === null) await commitEdit(next, "solve", burst);
  }, burst);
}

async function step(move: typeof steps.undo<Design>): Promise<void> {
  client.dropStreams();
  await inTurn(async () => {
    const from = history.value;
    const to = from && move(from);
    if (!to || to === from) return;
    notice.value = null;
    if (await show(to.present)) history.value = to;
    else await showPresent();
  });
}

export const undo = (): Promise<void> => step(steps.undo);
export const redo = (): Promise<void> => step(steps.redo);
