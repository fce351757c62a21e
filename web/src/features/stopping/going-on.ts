// SPDX-License-Identifier: MIT
// Further towards a target that was not reached: one press for each way on.

import { computed } from "@preact/signals";
import { type Design, type HandleRow, leftBehind, toTargets } from "../../design/design.ts";
import { basePoint, commitEdit, shownPoint } from "../../state/editing.ts";
import { kept, type Page } from "../../state/page.ts";
import { inTurn, type Outcome } from "../../state/turns.ts";
import { beyond, wanted } from "../../state/wanted.ts";
import { gotWords, type Reason, reasonOf, type Stop, stopOf, type WayOn } from "./way-on.ts";

export interface Stopped {
  readonly stop: Stop;
  readonly reason: Reason;
  /** As in Wanted. */
  readonly growth: number | null;
}

function stopIn(page: Page, design: Design, rows: readonly HandleRow[]): Stop | null {
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
    return stop && { stop, reason: reasonOf(design, pull !== null), growth };
  }),
);

/** The same targets again; what that gives is said, also where it is no more than before. */
export const goOn = (page: Page, way: WayOn): Outcome =>
  inTurn(page, async () => {
    const [design, before] = [page.history.value?.present, stopped(page).value];
    if (!design || !before) return;
    const handles = beyond(page).value?.handles ?? design.handles;
    const settings = { ...design.settings, ...way.change, continuation: 0 };
    const from = toTargets(design.handles).handles;
    const limit =
      way.growth === null ? null : { degrees: way.growth, short: Number.POSITIVE_INFINITY, from };
    const made = await commitEdit(
      page,
      { ...design, handles, settings },
      limit ? "release" : "solve",
      null,
      limit,
    );
    if (!made?.ok) return made;
    const done = made.value;
    const takenBack = done.handles !== handles;
    wanted(page).value = takenBack ? { handles, growth: way.growth, design: done } : null;
    const stop = stopIn(page, done, handles);
    if (stop && stop.got <= 1.01 * before.stop.got)
      page.notice.value = `${way.label} gets no further: ${gotWords(stop, page.unit.value)}.`;
    return made;
  });
