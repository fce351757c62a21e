// SPDX-License-Identifier: MIT
// Further towards a target that was not reached: one press for each way on.

import { computed } from "@preact/signals";
import { type Design, type HandleRow, leftBehind, toTargets } from "../../design/design.ts";
import { extentOf } from "../../mesh/extent.ts";
import { add, minus } from "../../mesh/vector.ts";
import type { EditSettings, PullLimit } from "../../solver/protocol.ts";
import { enqueue, type Outcome } from "../../state/action-queue.ts";
import { basePoint, commitEdit, longestWay, shownPoint } from "../../state/editing.ts";
import { kept, type Page } from "../../state/page.ts";
import {
  growthOf,
  lastRefusedPull,
  type RefusedPull,
  refusedPull,
} from "../../state/refused-pull.ts";
import { showStep } from "../../state/showing.ts";
import {
  gotWords,
  isLess,
  isNoFurther,
  type Reason,
  reasonOf,
  type Sought,
  type Stop,
  stopOf,
  type WayOn,
} from "./way-on.ts";

export interface Stopped {
  readonly stop: Stop;
  readonly reason: Reason;
  /** As in RefusedPull. */
  readonly growth: number | null;
  readonly sought: Sought;
}

export function stopIn(page: Page, design: Design, rows: readonly HandleRow[]): Stop | null {
  const meanEdge = page.mesh.value?.report.meanEdge ?? 0;
  return stopOf(
    rows,
    (vertex) => basePoint(page, vertex),
    (vertex) => shownPoint(page, vertex, design.shape),
    meanEdge,
  );
}

/** Frames go the shortest way: where a limit held them back, an edit may get further within it. */
function soughtBy(pull: RefusedPull | null, reason: Reason): Sought {
  if (!pull) return "given";
  const limited = reason === "fold" || reason === "limits" || reason === "unknown";
  return pull.dragged && limited ? "dragged" : "searched";
}

/** Of the last finished edit; null where it reached its targets, and for a variation of it. */
export const stopped = kept((page) =>
  computed((): Stopped | null => {
    const design = page.history.value?.present;
    if (!design || !page.mesh.value || leftBehind(design)) return null;
    const pull = refusedPull(page).value?.design === design ? refusedPull(page).value : null;
    const stop = stopIn(page, design, pull?.handles ?? design.handles);
    const growth = pull?.growth ?? null;
    const reason = reasonOf(design, pull !== null, growth);
    return stop && { stop, reason, growth, sought: soughtBy(pull, reason) };
  }),
);

/** Handles whose targets are further on than those of the design; of targets that it has, those that it does
 * not reach. */
function pulledOf(page: Page, design: Design, asked: readonly HandleRow[]): readonly HandleRow[] {
  if (asked === design.handles) return asked.filter((row) => stopIn(page, design, [row]) !== null);
  return asked.filter(({ vertex, target }) => {
    const now = design.handles.find((row) => row.vertex === vertex)?.target;
    return target.some((x, axis) => x !== now?.[axis]);
  });
}

/** Targets that are further than the mesh is large would cost a search its first tries. */
function withinSize(page: Page, pulled: readonly HandleRow[]): readonly HandleRow[] {
  const { low, high } = extentOf(page.mesh.value?.positions ?? []);
  const size = Math.hypot(...high.map((top, axis) => top - (low[axis] ?? 0)));
  const share = size / longestWay(page, pulled);
  if (!(share < 1)) return pulled;
  return pulled.map((row) => {
    const from = basePoint(page, row.vertex);
    return { ...row, target: add(from, minus(row.target, from), share) };
  });
}

/** From where the points are that are pulled. */
function limitOf(
  page: Page,
  asked: readonly HandleRow[],
  pulled: readonly HandleRow[],
  degrees: number,
): PullLimit {
  const based = asked.map((row) => ({ ...row, target: basePoint(page, row.vertex) }));
  const from = based.map((row, k) => (pulled.includes(asked[k] ?? row) ? row : (asked[k] ?? row)));
  return {
    degrees,
    short: 0,
    from: toTargets(from).handles,
    base: toTargets(based).handles,
  };
}

/** Without the limit on folds that the pull was held back by, if that is how the way goes on. */
function settingsOn(design: Design, way: WayOn, growth: number | null): EditSettings {
  const { limits } = design.settings;
  const others = growth === null ? limits : limits.filter((limit) => limit !== `fold=+${growth}`);
  return { ...design.settings, limits: others, ...way.change, continuation: 0 };
}

/** Edits of a search towards a target that was given: it may be as far away as one types. */
const FAR_TRIES = 8;

/** An edit towards targets that may be further on than its own. */
export interface Asked {
  readonly next: Design;
  readonly limit: PullLimit | null;
  readonly handles: readonly HandleRow[];
}

/** The edit that a way on makes of `design`, whose pull is held back by `growth` as in RefusedPull. */
export function askedBy(page: Page, design: Design, way: WayOn, growth: number | null): Asked {
  const handles = refusedPull(page).value?.handles ?? design.handles;
  const next = { ...design, handles, settings: settingsOn(design, way, growth), variation: null };
  if (way.growth === null) return { next, limit: null, handles };
  const pulled = pulledOf(page, design, handles);
  const nearer = withinSize(page, pulled);
  const rows =
    nearer === pulled ? handles : handles.map((row) => nearer[pulled.indexOf(row)] ?? row);
  const limit = limitOf(page, rows, nearer, way.growth);
  const far = handles === design.handles ? { tries: FAR_TRIES } : {};
  return { next: { ...next, handles: rows }, limit: { ...limit, ...far }, handles };
}

const noFurther = (page: Page, { label }: WayOn, stop: Stop): string =>
  `${label} gets no further: ${gotWords(stop, page.unit.value)}.`;

/** Tries the targets again; what that gives is said, also where it is no more than before. Where it is less,
 * the design stays as it was. */
export const goOn = (page: Page, way: WayOn): Outcome =>
  enqueue(page, async () => {
    const [history, before] = [page.history.value, stopped(page).value];
    if (!history || !before) return;
    const { next, limit, handles } = askedBy(page, history.present, way, before.growth);
    const made = await commitEdit(page, next, limit ? "release" : "solve", null, { limit });
    if (!made?.ok) return made;
    const done = made.value;
    const stop = stopIn(page, done, handles);
    if (stop && isLess(stop.got, before.stop)) {
      const refusal = await showStep(page, history.present, history);
      if (!refusal) page.notice.value = noFurther(page, way, before.stop);
      return refusal;
    }
    const takenBack = done.handles !== handles;
    const growth = limit && growthOf(limit.degrees);
    lastRefusedPull(page).value = takenBack
      ? { handles, growth, dragged: false, design: done }
      : null;
    if (stop && isNoFurther(stop.got, before.stop)) page.notice.value = noFurther(page, way, stop);
    return made;
  });
