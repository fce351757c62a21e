// SPDX-License-Identifier: MIT
// The places of the slider between close to the file and fair, and what there is near the file at each.

import { extentOf } from "../../mesh/extent.ts";
import type { OpenedMesh, Planarising } from "../../solver/protocol.ts";

export interface Stop {
  readonly name: string;
  /** Weight of fairness. */
  readonly smooth: number;
  /** Share of the mesh's size: no point moves farther where every panel flat is not to be had. */
  readonly near: number;
}

export const STOPS: readonly Stop[] = [
  { name: "nearest", smooth: 0, near: 0.001 },
  { name: "close", smooth: 1, near: 0.003 },
  { name: "fair", smooth: 10, near: 0.01 },
  { name: "fairer", smooth: 100, near: 0.02 },
  { name: "fairest", smooth: 1000, near: 0.05 },
];

/** mm/m: the most that edits can live with. */
export const MOST_BENT = 20;

/** Of the size: who moves points farther makes another building. */
export const FAR = 0.01;

/** The place for a weight that may have come from elsewhere. */
export function stopOf(weight: number): number {
  const next = STOPS.findIndex(({ smooth }) => smooth >= weight);
  return next < 0 ? STOPS.length - 1 : next;
}

/** The longest side of the box around the mesh, model units. */
export function sizeOf({ positions }: Pick<OpenedMesh, "positions">): number {
  const { low, high } = extentOf(positions);
  return Math.max(...high.map((top, axis) => top - (low[axis] ?? 0)));
}

/** Whether a largest move is farther than anyone expects of making panels flat; model units. */
export const isFar = (largest: number, opened: Pick<OpenedMesh, "positions">): boolean =>
  largest > FAR * sizeOf(opened);

/** Two digits of it: "195", "0.0034". */
const rounded = (length: number): number => Number(length.toPrecision(2));

const within = (share: number, how: Planarising, opened: OpenedMesh): Planarising => ({
  ...how,
  flat: MOST_BENT,
  within: rounded(share * sizeOf(opened)),
});

/** As flat as panels get where points move by a share of the size at most. */
export const nearWay = (how: Planarising, opened: OpenedMesh): Planarising =>
  within(STOPS[stopOf(how.smooth)]?.near ?? FAR, how, opened);

/** The same for who goes as far as `largest`: nearer than that, however far the place of the slider goes. */
export function nearerWay(how: Planarising, opened: OpenedMesh, largest: number): Planarising {
  const near = nearWay(how, opened);
  return near.within < largest ? near : within(FAR, how, opened);
}

/** As flat as panels get within the smallest share of all stops, which is soon known. */
export const quickWay = (how: Planarising, opened: OpenedMesh): Planarising =>
  within(Math.min(...STOPS.map(({ near }) => near)), how, opened);

/** How many panels may be split, of a share in percent; 0: none. */
export const splitMost = (share: number, { report }: Pick<OpenedMesh, "report">): number =>
  share > 0 ? Math.max(1, Math.floor((share / 100) * report.faces)) : 0;
