// SPDX-License-Identifier: MIT
// What making the opened mesh flat did to it, before any edit.
import type { MeshReport, Planarising } from "../solver/protocol.ts";
import { formatLength, type Unit } from "./units.ts";

/** What links and designs mean that only say that a mesh was planarised. */
export const NEAREST_FLAT: Planarising = {
  smooth: 0,
  keepBoundary: false,
  keepShape: false,
  constraints: [],
};

/** The command line's default. */
export const FAIR_FLAT: Planarising = {
  smooth: 10,
  keepBoundary: false,
  keepShape: true,
  constraints: [],
};

/** What designs write as `true`, and links as 1. */
export const isNearestFlat = (how: Planarising): boolean =>
  how.smooth === 0 && !how.keepBoundary && !how.keepShape && how.constraints.length === 0;

/** "2570 points moved by up to 1675 mm"; "" where nothing had to be made flat. */
export function planarisingWords({ planarising }: MeshReport, unit: Unit): string {
  const { moved, largest } = planarising;
  if (moved === 0) return "";
  return `${moved} ${moved === 1 ? "point" : "points"} moved by up to ${formatLength(largest, unit)}`;
}
