// SPDX-License-Identifier: MIT
// What a double click on an edge means: the line of the mesh through it, or the strip across it.
import { lineThrough, ringThrough } from "../mesh/mesh-lines.ts";
import { pickEdge } from "./edge-picking.ts";
import type { Place, View } from "./picking.ts";
import type { Shell } from "./shell.ts";

/** The points; null beside every edge. */
export function pickLine(shell: Shell, place: Place, ring: boolean, view: View): number[] | null {
  const { base, current, offsets, vertices, topology, drawn } = shell;
  const edge = pickEdge(current, drawn, place, view);
  const mesh = { points: base, offsets, vertices, topology };
  return edge && (ring ? ringThrough : lineThrough)(mesh, edge);
}
