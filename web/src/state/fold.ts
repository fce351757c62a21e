// SPDX-License-Identifier: MIT
// How sharply neighbouring panels meet where an edit touches them, in words.
import type { ShapeReport } from "../solver/protocol.ts";

/** "14°", "3.2°", "0.04°": two digits that say something. */
export const formatDegrees = (degrees: number): string =>
  `${degrees >= 10 ? degrees.toFixed(0) : Number(degrees.toPrecision(2))}°`;

/** "sharpest fold 14° (was 3°)"; "" without an edit, and where it was not measured. */
export function foldWords({ movedVertices, sharpestFold }: ShapeReport): string {
  if (!sharpestFold || movedVertices === 0) return "";
  const [now, before] = [sharpestFold.after, sharpestFold.before].map(formatDegrees);
  return `sharpest fold ${now} (was ${before})`;
}
