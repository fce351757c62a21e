// SPDX-License-Identifier: MIT
// Where the mesh can move: measured in a worker of its own while the page goes on, point by point.

import type { MobilityNews, MobilityOrder, MobilityRow } from "../solver/mobility-worker.ts";
import workerUrl from "../solver/mobility-worker.ts?worker&url";
import type { EditSettings } from "../solver/protocol.ts";
import { reachable } from "../solver/reachable.ts";
import type { Point } from "./design.ts";
import { basePoint, commitEdit } from "./editing.ts";
import { selectOnly } from "./selection.ts";
import { draft, hintVertex, type Mobility, mesh, mobility, notice, settings } from "./store.ts";
import { inTurn } from "./turns.ts";

export type { MobilityRow };

/** Face rings within which the map moves anything: the core's. */
const REACH = 4;

let worker: Worker | null = null;

const order = (given: MobilityOrder): void => worker?.postMessage(given);

/** What of the settings changes the map, to be compared. */
function essence(chosen: EditSettings): string {
  const own = { hardHandles: true, reach: REACH, reachLength: 0, continuation: 0 };
  return JSON.stringify({ ...chosen, ...own, boundarySupport: "none" });
}

/** Whether the map was measured under other settings than those of now. */
export const isOutdated = (map: Mobility): boolean =>
  settings.value !== null && essence(map.settings) !== essence(settings.value);

function update(change: Partial<Mobility>): void {
  if (mobility.value) mobility.value = { ...mobility.value, ...change };
}

function receive(news: MobilityNews): void {
  const map = mobility.value;
  if (!map) return;
  if (news.kind === "failed") {
    update({ running: false, problem: news.message });
    return;
  }
  const ways = map.ways.slice();
  news.points.forEach((vertex, k) => {
    ways[vertex] = news.ways[k] ?? 0;
  });
  const measured = map.measured + news.points.length;
  const running = map.running && measured < ways.length;
  update({ ways, measured, running, best: news.best });
}

/** Measures the mesh that is open from the beginning, or goes on where it was stopped. */
export function measureMobility(): void {
  const [opened, chosen] = [mesh.value, settings.value];
  if (!opened || !chosen) return;
  const map = mobility.value;
  if (map?.of === opened && worker && !isOutdated(map)) {
    if (map.measured === map.ways.length) return;
    update({ running: true });
    order({ kind: "go" });
    return;
  }
  worker?.terminate();
  worker = new Worker(reachable(workerUrl), { type: "module" });
  worker.onmessage = ({ data }: MessageEvent<MobilityNews>) => receive(data);
  worker.onerror = (event) => {
    event.preventDefault();
    receive({ kind: "failed", message: "The map could not be measured. Try again online." });
  };
  const ways = new Float32Array(opened.positions.length / 3);
  const fresh = { ways, measured: 0, best: [], running: true, problem: null };
  mobility.value = { of: opened, settings: chosen, ...fresh };
  const { positions, offsets, vertices } = opened;
  order({ kind: "open", positions, offsets, vertices, settings: chosen });
  order({ kind: "go" });
}

/** After the point that is being measured. */
export function stopMobility(): void {
  order({ kind: "stop" });
  update({ running: false });
}

/** A place as an edit of its own: what the row says was found for exactly this point and way. */
export const openPlace = ({ vertex, direction, distance }: MobilityRow): Promise<void> =>
  inTurn(async () => {
    const design = draft.value;
    if (!design) return;
    const from = basePoint(vertex);
    const along = (axis: 0 | 1 | 2): number => from[axis] + distance * direction[axis];
    const target: Point = [along(0), along(1), along(2)];
    const others = design.handles.some((row) => row.vertex !== vertex);
    hintVertex.value = null;
    selectOnly(vertex);
    const chosen = { ...design.settings, hardHandles: true, reach: REACH, reachLength: 0 };
    const handles = [{ vertex, target, pinned: false }];
    await commitEdit({ ...design, handles, settings: chosen }, "solve");
    if (others) notice.value = "An edit of its own: Undo brings back the one before.";
  });
