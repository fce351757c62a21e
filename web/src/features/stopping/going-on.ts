// SPDX-License-Identifier: MIT
// Further towards a target that was not reached: one press for each way on.

import { computed } from "@preact/signals";
import { type Design, type HandleRow, leftBehind, toTargets } from "../../design/design.ts";
import type { EditSettings, PullLimit } from "../../solver/protocol.ts";
import { basePoint, commitEdit, shownPoint } from "../../state/editing.ts";
import { kept, type Page } from "../../state/page.ts";
import { showStep } from "../../state/showing.ts";
import { inTurn, type Outcome } from "../../state/turns.ts";
import { beyond, growthOf, wanted } from "../../state/wanted.ts";
import {
  gotWords,
  isLess,
  isNoFurther,
  type Reason,
  reasonOf,
  type Stop,
  stopOf,
  type WayOn,
} from "./way-on.ts";

export interface Stopped {
  readonly stop: Stop;
  readonly reason: Reason;
  /** As in Wanted. */
  readonly growth: number | null;
  /** A limit held the frames of a drag back, which go the shortest way: an edit may get further within it. */
  readonly dragged: boolean;
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

/** Of the last finished edit; null where it reached its targets, and for a variation of it. */
export const stopped = kept((page) =>
  computed((): Stopped | null => {
    const design = page.history.value?.present;
    if (!design || !page.mesh.value || leftBehind(design)) return null;
    const pull = beyond(page).value?.design === design ? beyond(page).value : null;
    const stop = stopIn(page, design, pull?.handles ?? design.handles);
    const growth = pull?.growth ?? null;
    const reason = reasonOf(design, pull !== null, growth);
    const dragged = pull?.dragged === true && (reason === "fold" || reason === "limits");
    return stop && { stop, reason, growth, dragged };
  }),
);

/** From where the points are whose targets are further on. */
function limitOf(
  page: Page,
  design: Design,
  asked: readonly HandleRow[],
  degrees: number,
): PullLimit {
  const based = asked.map((row) => ({ ...row, target: basePoint(page, row.vertex) }));
  const pulled = asked.filter(({ vertex, target }) => {
    const now = design.handles.find((row) => row.vertex === vertex)?.target;
    return target.some((x, axis) => x !== now?.[axis]);
  });
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

/** The edit that a way on makes of `design`, whose pull is held back by `growth` as in Wanted. */
export function askedBy(
  page: Page,
  design: Design,
  way: WayOn,
  growth: number | null,
): { readonly next: Design; readonly limit: PullLimit | null } {
  const handles = beyond(page).value?.handles ?? design.handles;
  return {
    next: { ...design, handles, settings: settingsOn(design, way, growth), variation: null },
    limit: way.growth === null ? null : limitOf(page, design, handles, way.growth),
  };
}

const noFurther = (page: Page, { label }: WayOn, stop: Stop): string =>
  `${label} gets no further: ${gotWords(stop, page.unit.value)}.`;

/** Tries the targets again; what that gives is said, also where it is no more than before. Where it is less,
 * the design stays as it was. */
export const goOn = (page: Page, way: WayOn): Outcome =>
  inTurn(page, async () => {
    const [history, before] = [page.history.value, stopped(page).value];
    if (!history || !before) return;
    const { next, limit } = askedBy(page, history.present, way, before.growth);
    const { handles } = next;
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
    wanted(page).value = takenBack ? { handles, growth, dragged: false, design: done } : null;
    if (stop && isNoFurther(stop.got, before.stop)) page.notice.value = noFurther(page, way, stop);
    return made;
  });
