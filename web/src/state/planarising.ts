// SPDX-License-Identifier: MIT
// What making the opened mesh flat did to it, before any edit.
import type { MeshReport } from "../solver/protocol.ts";
import { formatLength, type Unit } from "./units.ts";

/** "2570 points moved by up to 1675 mm"; "" where nothing had to be made flat. */
export function planarisingWords({ planarising }: MeshReport, unit: Unit): string {
  const { moved, largest } = planarising;
  if (moved === 0) return "";
  return `${moved} ${moved === 1 ? "point" : "points"} moved by up to ${formatLength(largest, unit)}`;
}
