// SPDX-License-Identifier: MIT
import { row } from "../mesh/topology.ts";
import { project, type View } from "./picking.ts";
import type { Shell } from "./shell.ts";

/** The vertex across the edge in the picture that points most nearly in a direction on screen. */
export function neighbourTowards(
  shell: Shell,
  vertex: number,
  right: number,
  down: number,
  view: View,
): number {
  const from = project(shell.current, vertex, view);
  if (!from) return vertex;
  const { edges, edgeEnds } = shell.drawn;
  let best = vertex;
  let closest = 0.3;
  for (const end of row(edgeEnds, vertex)) {
    const other = edges[end ^ 1] ?? vertex;
    const to = project(shell.current, other, view);
    if (!to) continue;
    const [dx, dy] = [to.x - from.x, to.y - from.y];
    const cosine = (dx * right + dy * down) / (Math.hypot(dx, dy) || 1);
    if (cosine > closest) {
      closest = cosine;
      best = other;
    }
  }
  return best;
}
