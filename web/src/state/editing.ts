// SPDX-License-Identifier: MIT
// Every way to change an edit. Each ends as one step of the history.

import { buildableCorners, fairFolds, newSliver } from "virtual:core-defaults";
import {
  type Design,
  FIRST_SETTINGS,
  type HandleRow,
  leftBehind,
  NO_SHAPE,
  type Point,
  toTargets,
  withHandle,
  withoutHandle,
  withTaken,
} from "../design/design.ts";
import * as steps from "../design/history.ts";
import { limitNumbers } from "../design/stated-limit.ts";
import { withoutImages } from "../design/symmetry.ts";
import { row } from "../mesh/topology.ts";
import { GIVEN_UP } from "../result/result.ts";
import type { Answer, Question } from "../solver/client.ts";
import { foldGrowth } from "../solver/found-limits.ts";
import type {
  EditMode,
  EditSettings,
  PullLimit,
  Shape,
  ShapeReport,
  SoughtLimits,
} from "../solver/protocol.ts";
import { REACHES } from "../solver/reach-steps.ts";
import { enqueue, type Outcome } from "./action-queue.ts";
import { isSeen } from "./camera.ts";
import { client, frame, run } from "./connection.ts";
import { kept, type Page } from "./page.ts";
import { firstReach, noteReach, noteReachOfSource, reachesFor } from "./reach-choice.ts";
import { selectOnly } from "./selection.ts";
import { sensibleVertex } from "./sensible-vertex.ts";
import { openBase, restorePresent, showStep } from "./showing.ts";

/** A drag frame may take this long; what it has then is exact, if not yet optimal. */
const FRAME_SECONDS = 0.016;

export function basePoint(page: Page, vertex: number): Point {
  const p = page.mesh.value?.positions;
  return [p?.[3 * vertex] ?? 0, p?.[3 * vertex + 1] ?? 0, p?.[3 * vertex + 2] ?? 0];
}

export const handleOf = (page: Page, vertex: number): HandleRow | undefined =>
  page.draft.value?.handles.find((row) => row.vertex === vertex);

/** How an edit is looked for: see protocol.ts. */
export interface Tried {
  readonly limit?: PullLimit | null;
  readonly sought?: SoughtLimits | null;
  readonly reaches?: readonly number[];
}

/** What makes the solver compute the edit of `design`. */
export function editQuestion(
  design: Design,
  mode: EditMode,
  { limit = null, sought = null, reaches = [] }: Tried = {},
): Question {
  const targets = toTargets(design.handles);
  if (targets.handles.length === 0)
    return { kind: "restore", targets, settings: design.settings, shape: NO_SHAPE, keep: false };
  const { settings } = design;
  return { kind: "edit", mode, targets, settings, budget: FRAME_SECONDS, limit, sought, reaches };
}

/** The way of the handle that goes furthest from the base, model units. */
export function longestWay(page: Page, rows: readonly HandleRow[]): number {
  const ways = rows
    .filter(({ pinned }) => !pinned)
    .map(({ vertex, target }) => {
      const from = basePoint(page, vertex);
      return Math.hypot(...target.map((x, axis) => x - (from[axis] ?? 0)));
    });
  return Math.max(0, ...ways);
}

/** Limits that are kept to without being asked for: not under raw weights, nor where folds or corners have a limit of their
 * own or are beyond it in what is shown already. */
function soughtFor(page: Page, { settings, handles }: Design): SoughtLimits | null {
  const { softness, hardHandles, limits } = settings;
  if (softness === 0 || hardHandles) return null;
  const isFree = (head: string): boolean => !limits.some((limit) => limit.startsWith(head));
  const isSharp = foldGrowth(page.figures.value) > (fairFolds[0] ?? 0);
  const isThin = page.panelDamage.value?.includes(newSliver) ?? false;
  return {
    way: longestWay(page, handles),
    folds: isFree("fold=") && !isSharp,
    corners: isFree("angle=") && !isThin,
  };
}

/** What an edit finds of itself: limits, and how far it has to reach. */
const unasked = (page: Page, design: Design): Tried => ({
  sought: soughtFor(page, design),
  reaches: reachesFor(page, design),
});

interface Own {
  /** The last burst of keys on a slider and what it gave. */
  latest: { readonly burst: string; readonly design: Design } | null;
}

const own = kept((): Own => ({ latest: null }));

/** Keys on a slider, one after the other, are one step of the history. */
function recordStep(
  page: Page,
  steady: steps.History<Design>,
  done: Design,
  burst: string | null,
): void {
  const goesOn = goesOnFrom(page, steady.present, burst);
  page.history.value = goesOn ? steps.amend(steady, done) : steps.record(steady, done);
  own(page).latest = burst === null ? null : { burst, design: done };
}

const goesOnFrom = (page: Page, design: Design | undefined, burst: string | null): boolean => {
  const { latest } = own(page);
  return burst !== null && latest?.burst === burst && latest.design === design;
};

type Made = Extract<Answer, { kind: "shown" }> & { readonly shape: Shape };

/**
 * Computes `next` and records it; a failure keeps the last design, on screen and in the solver.
 * @param burst names the keys on a slider that it is one of
 */
export async function commit(
  page: Page,
  next: Design,
  ask: Question,
  label: string,
  burst: string | null = null,
): Outcome<Design> {
  page.draft.value = next;
  if (!goesOnFrom(page, page.history.value?.present, burst)) page.notice.value = null;
  const answer = await run(page, label, ask, "shown");
  const steady = page.history.value;
  if (!answer.ok || !steady) return answer.ok ? undefined : restorePresent(page, answer);
  const { shape, found } = answer.value;
  if (!shape) return restorePresent(page, GIVEN_UP);
  const done = designOf(next, ask, { ...answer.value, shape });
  recordStep(page, steady, done, burst);
  if (page.draft.value === next) page.draft.value = done;
  if (found.length > 0) page.notice.value = `${found.map(keptTo).join(" ")} ${GO_ON}`;
  if (leftBehind(steady.present) && !done.variation) page.notice.value = LEFT_BEHIND;
  return { ok: true, value: done };
}

/** `next` as the solver made it. */
export function designOf(
  next: Design,
  ask: Question,
  { shape, report, taken, placed, found, reach }: Made,
): Design {
  const to = taken ?? placed;
  const handles = to ? withTaken(next.handles, to) : next.handles;
  const limits = [...next.settings.limits, ...found];
  const continuation = continuationOf(ask, report, next);
  const settings = { ...next.settings, limits, reach: reach ?? next.settings.reach, continuation };
  return { ...next, handles, settings, shape, report };
}

/** The steps that an edit took; a variation of it leaves them as they are. */
function continuationOf(ask: Question, report: ShapeReport, { settings }: Design): number {
  if (ask.kind === "edit") return report.continuation ?? 0;
  return ask.kind === "restore" ? 0 : settings.continuation;
}

const keptTo = (limit: string): string => {
  const [low, high] = limitNumbers(limit);
  if (limit === buildableCorners) return `Corners are kept between ${low}° and ${high}°.`;
  return `Folds are kept to ${low}° sharper than they were.`;
};

const GO_ON = "To let them go, use Limits.";

const LEFT_BEHIND =
  "The variation was left behind: Undo brings it back. To keep it, use Continue from this shape first.";

/** An edit starts from the base: a variation of the edit before it does not belong to it. */
export const commitEdit = (
  page: Page,
  next: Design,
  mode: EditMode,
  burst: string | null = null,
  tried: Tried = {},
): Outcome<Design> =>
  commit(page, { ...next, variation: null }, editQuestion(next, mode, tried), "computing", burst);

function changed(page: Page, rows: readonly HandleRow[]): Design | null {
  const { value } = page.draft;
  if (!value) return null;
  const settings = rows.length > 0 ? value.settings : firstReach(page, value.settings);
  return { ...value, handles: rows, settings };
}

/** `rows` without images of what has changed in them: those go where it makes them. */
export function speaking(
  page: Page,
  before: readonly HandleRow[],
  rows: readonly HandleRow[],
): HandleRow[] {
  const orbits = page.mesh.value?.symmetry?.orbits;
  return orbits ? withoutImages(orbits, before, rows) : [...rows];
}

/** Makes one edit of the handles as they are when its turn comes. */
export const edit = (
  page: Page,
  change: (rows: readonly HandleRow[]) => HandleRow[],
  burst: string | null = null,
): Outcome =>
  enqueue(
    page,
    async () => {
      const before = page.draft.value?.handles ?? [];
      const next = changed(page, speaking(page, before, change(before)));
      if (!next) return;
      const asked = { ...next, variation: null };
      noteReachOfSource(page, asked);
      const question = editQuestion(asked, "solve", unasked(page, asked));
      return commit(page, asked, question, "computing", burst);
    },
    burst,
  );

export function setTarget(
  page: Page,
  vertex: number,
  target: Point,
  burst: string | null = null,
): Outcome {
  page.hintVertex.value = null;
  return edit(page, (rows) => withHandle(rows, { vertex, target, pinned: false }), burst);
}

/** Pins points to where the base has them, or lets them go. */
export async function setPinned(page: Page, vertices: readonly number[], pinned: boolean): Outcome {
  const [back] = pinned ? vertices.filter((vertex) => isMovedHandle(page, vertex)) : [];
  const made = await edit(page, (rows) => {
    let next = [...rows];
    for (const vertex of vertices) {
      const target = handleOf(page, vertex)?.target ?? basePoint(page, vertex);
      next = withHandle(next, { vertex, target, pinned });
    }
    return next;
  });
  if (made?.ok && back !== undefined)
    page.notice.value = `Pinned points stay where the mesh has them: point ${back} went back. Unpin it and it goes to its target again.`;
  return made;
}

/** Whether a pin would take it back. */
function isMovedHandle(page: Page, vertex: number): boolean {
  const row = handleOf(page, vertex);
  const base = basePoint(page, vertex);
  return row !== undefined && !row.pinned && row.target.some((x, axis) => x !== base[axis]);
}

/** Adds the selected point, or a sensible one. */
export async function addHandle(page: Page): Outcome {
  const opened = page.mesh.value;
  if (!opened) return;
  const taken = page.draft.value?.handles.map((row) => row.vertex) ?? [];
  const chosen =
    page.selected.value !== null && !taken.includes(page.selected.value)
      ? page.selected.value
      : sensibleVertex(opened.display, opened.topology.boundary, taken, (vertex) =>
          isSeen(page, vertex),
        );
  if (chosen === null) return;
  selectOnly(page, chosen);
  return setTarget(page, chosen, shownPoint(page, chosen));
}

/** Where the design, or another shape of its mesh, has a vertex; model units. */
export function shownPoint(
  page: Page,
  vertex: number,
  shape = page.draft.value?.shape ?? NO_SHAPE,
): Point {
  const k = shape.moved.indexOf(vertex);
  if (k < 0) return basePoint(page, vertex);
  const p = shape.positions;
  return [p[3 * k] ?? 0, p[3 * k + 1] ?? 0, p[3 * k + 2] ?? 0];
}

export const removeHandle = (page: Page, vertex: number): Outcome =>
  edit(page, (rows) => withoutHandle(rows, vertex));

export function removeHandles(page: Page, vertices: readonly number[]): Outcome {
  const gone = new Set(vertices);
  return edit(page, (rows) => rows.filter((row) => !gone.has(row.vertex)));
}

/** Lets pinned points go: those that were to go somewhere go there again, the others are no handles. */
export function freePins(page: Page, vertices: readonly number[]): Outcome {
  const freed = new Set(vertices);
  const stays = ({ vertex, target }: HandleRow): boolean =>
    basePoint(page, vertex).every((x, axis) => x === target[axis]);
  return edit(page, (rows) =>
    rows.flatMap((row) => {
      if (!row.pinned || !freed.has(row.vertex)) return [row];
      return stays(row) ? [] : [{ ...row, pinned: false }];
    }),
  );
}

/** Shows the edit while a weight's slider moves. */
export function previewSettings(page: Page, change: Partial<EditSettings>): void {
  if (!page.draft.value) return;
  noteReach(page, change);
  const next = { ...page.draft.value, settings: { ...page.draft.value.settings, ...change } };
  page.draft.value = next;
  if (next.handles.length > 0) void frame(page, editQuestion(next, "drag"));
}

/** An edit cannot be flatter than what it does not move; without one the tolerance is only noted. */
const needsFlatterMesh = (page: Page, { handles, settings }: Design): boolean =>
  toTargets(handles).handles.length > 0 &&
  (page.mesh.value?.report.worstExcess ?? 0) > settings.tolerance;

/** `design` without handles at points that belong to no panel of the open mesh: cuts may have taken them. */
function withHandlesLeft(page: Page, design: Design): Design {
  const corners = page.mesh.value?.topology.corners;
  if (!corners) return design;
  const handles = design.handles.filter(({ vertex }) => row(corners, vertex).length > 0);
  return handles.length === design.handles.length ? design : { ...design, handles };
}

/** Notes which of the committed limits someone states; the page itself may have found the others. */
function noteStated(page: Page, { limits }: EditSettings, next: readonly string[]): void {
  const stated = page.statedLimits.value;
  page.statedLimits.value = next.filter((one) => stated.includes(one) || !limits.includes(one));
}

export function commitSettings(
  page: Page,
  change: Partial<EditSettings>,
  burst: string | null = null,
): Outcome {
  client(page).dropStreams();
  return enqueue(
    page,
    async () => {
      const design = page.draft.value;
      if (!design) return;
      const next = { ...design, settings: { ...design.settings, ...change } };
      noteReach(page, change);
      if (change.limits) noteStated(page, design.settings, change.limits);
      page.refusedTolerance.value = needsFlatterMesh(page, next) ? next.settings.tolerance : null;
      if (page.refusedTolerance.value !== null) return;
      const based = await openBase(page, next);
      if (!based.ok) return restorePresent(page, based);
      const left = change.cuts ? withHandlesLeft(page, based.value) : based.value;
      return commitEdit(page, left, "solve", burst);
    },
    burst,
  );
}

/** The reach is nobody's choice any more: the edit is made again with the smallest that suffices. */
export const letReachGrow = (page: Page): Outcome =>
  enqueue(page, async () => {
    const { value } = page.draft;
    if (!value) return;
    page.reachChosen.value = false;
    const asked = toTargets(value.handles).handles.length > 0;
    const reach = asked ? Math.min(...REACHES) : FIRST_SETTINGS.reach;
    const settings = { ...value.settings, reach, reachLength: 0 };
    const next = { ...value, settings, variation: null };
    return commit(page, next, editQuestion(next, "solve", unasked(page, next)), "computing");
  });

function step(page: Page, move: typeof steps.undo<Design>): Outcome {
  client(page).dropStreams();
  return enqueue(page, async () => {
    const from = page.history.value;
    const to = from && move(from);
    if (!to || to === from) return;
    page.notice.value = null;
    return showStep(page, to.present, to);
  });
}

export const undo = (page: Page): Outcome => step(page, steps.undo);

export const redo = (page: Page): Outcome => step(page, steps.redo);
