// SPDX-License-Identifier: MIT
// Where the mesh can move: measured in a worker of its own while the page goes on, point by point.

import type { Point } from "../../design/design.ts";
import type { MobilityNews, MobilityOrder, MobilityRow } from "../../solver/mobility-worker.ts";
import workerUrl from "../../solver/mobility-worker.ts?worker&url";
import type { EditSettings } from "../../solver/protocol.ts";
import { reachable } from "../../solver/reachable.ts";
import { enqueue, type Outcome } from "../../state/action-queue.ts";
import { basePoint, commitEdit } from "../../state/editing.ts";
import { kept, type Page } from "../../state/page.ts";
import type { Mobility } from "../../state/page-state.ts";
import { selectOnly } from "../../state/selection.ts";

export type { MobilityRow };

/** Face rings within which the map moves anything: the core's. */
const REACH = 4;

interface Own {
  worker: Worker | null;
}

const own = kept((): Own => ({ worker: null }));

const order = (page: Page, given: MobilityOrder): void => own(page).worker?.postMessage(given);

/** What of the settings changes the map, to be compared. */
function essence(chosen: EditSettings): string {
  const own = { hardHandles: true, reach: REACH, reachLength: 0, continuation: 0 };
  return JSON.stringify({ ...chosen, ...own, supports: [] });
}

/** Whether the map was measured under other settings than those of now. */
export const isOutdated = (page: Page, map: Mobility): boolean =>
  page.settings.value !== null && essence(map.settings) !== essence(page.settings.value);

function update(page: Page, change: Partial<Mobility>): void {
  if (page.mobility.value) page.mobility.value = { ...page.mobility.value, ...change };
}

function receive(page: Page, news: MobilityNews): void {
  const map = page.mobility.value;
  if (!map) return;
  if (news.kind === "failed") {
    update(page, { running: false, problem: news.message });
    return;
  }
  const ways = map.ways.slice();
  news.points.forEach((vertex, k) => {
    ways[vertex] = news.ways[k] ?? 0;
  });
  const measured = map.measured + news.points.length;
  const running = map.running && measured < ways.length;
  update(page, { ways, measured, running, best: news.best });
}

/** Measures the mesh that is open from the beginning, or goes on where it was stopped. */
export function measureMobility(page: Page): void {
  const [opened, chosen] = [page.mesh.value, page.settings.value];
  if (!opened || !chosen) return;
  const map = page.mobility.value;
  if (map?.of === opened && own(page).worker && !isOutdated(page, map)) {
    if (map.measured === map.ways.length) return;
    update(page, { running: true });
    order(page, { kind: "go" });
    return;
  }
  own(page).worker?.terminate();
  const worker = new Worker(reachable(workerUrl), { type: "module" });
  own(page).worker = worker;
  worker.onmessage = ({ data }: MessageEvent<MobilityNews>) => receive(page, data);
  worker.onerror = (event) => {
    event.preventDefault();
    receive(page, { kind: "failed", message: "The map could not be measured. Try again online." });
  };
  const ways = new Float32Array(opened.positions.length / 3);
  const fresh = { ways, measured: 0, best: [], running: true, problem: null };
  page.mobility.value = { of: opened, settings: chosen, ...fresh };
  const { positions, offsets, vertices } = opened;
  order(page, { kind: "open", positions, offsets, vertices, settings: chosen });
  order(page, { kind: "go" });
}

/** Stops after the point that is being measured. */
export function stopMobility(page: Page): void {
  order(page, { kind: "stop" });
  update(page, { running: false });
}

/** A place as an edit of its own: what the row says was found for exactly this point and way. */
export const openPlace = (page: Page, { vertex, direction, distance }: MobilityRow): Outcome =>
  enqueue(page, async () => {
    const design = page.draft.value;
    if (!design) return;
    const from = basePoint(page, vertex);
    const along = (axis: 0 | 1 | 2): number => from[axis] + distance * direction[axis];
    const target: Point = [along(0), along(1), along(2)];
    const others = design.handles.some((row) => row.vertex !== vertex);
    page.hintVertex.value = null;
    selectOnly(page, vertex);
    const chosen = { ...design.settings, hardHandles: true, reach: REACH, reachLength: 0 };
    const handles = [{ vertex, target, pinned: false }];
    const made = await commitEdit(page, { ...design, handles, settings: chosen }, "solve");
    if (others) page.notice.value = "An edit of its own: Undo brings back the one before.";
    return made;
  });
