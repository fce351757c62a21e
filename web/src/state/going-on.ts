// SPDX-License-Identifier: MIT
// Further towards a target that was not reached: one press for each way on.
import { computed } from "@preact/signals";
import { type Design, type HandleRow, leftBehind, toTargets } from "./design.ts";
import { basePoint, commitEdit, shownPoint } from "./editing.ts";
import { history, mesh, notice, problem, unit } from "./store.ts";
import { inTurn } from "./turns.ts";
import { beyond, wanted } from "./wanted.ts";
import { gotWords, type Reason, reasonOf, type Stop, stopOf, type WayOn } from "./way-on.ts";

export interface Stopped {
  readonly stop: Stop;
  readonly reason: Reason;
  /** As in Wanted. */
  readonly growth: number | null;
}

function stopIn(design: Design, rows: readonly HandleRow[]): Stop | null {
  const meanEdge = mesh.value?.report.meanEdge ?? 0;
  return stopOf(rows, basePoint, (vertex) => shownPoint(vertex, design.shape), meanEdge);
}

/** Of the last finished edit; null where it reached its targets, and for a variation of it. */
export const stopped = computed((): Stopped | null => {
  const design = history.value?.present;
  if (!design || !mesh.value || leftBehind(design)) return null;
  const pull = beyond.value?.design === design ? beyond.value : null;
  const stop = stopIn(design, pull?.handles ?? design.handles);
  const growth = pull?.growth ?? null;
  return stop && { stop, reason: reasonOf(design, pull !== null), growth };
});

/** The same targets again; what that gives is said, also where it is no more than before. */
export const goOn = (way: WayOn): Promise<void> =>
  inTurn(async () => {
    const [design, before] = [history.value?.present, stopped.value];
    if (!design || !before) return;
    const handles = beyond.value?.handles ?? design.handles;
    const settings = { ...design.settings, ...way.change, continuation: 0 };
    const from = toTargets(design.handles).handles;
    const limit =
      way.growth === null ? null : { degrees: way.growth, short: Number.POSITIVE_INFINITY, from };
    await commitEdit({ ...design, handles, settings }, limit ? "release" : "solve", null, limit);
    const done = history.value?.present;
    if (problem.value || !done || done === design) return;
    const takenBack = done.handles !== handles;
    wanted.value = takenBack ? { handles, growth: way.growth, design: done } : null;
    const stop = stopIn(done, handles);
    if (stop && stop.got <= 1.01 * before.stop.got)
      notice.value = `${way.label} gets no further: ${gotWords(stop, unit.value)}.`;
  });
