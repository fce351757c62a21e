// SPDX-License-Identifier: MIT
// What a double click on an edge means: the line of the mesh through it, or the strip across it.

import { type Edge, lineThrough, ringThrough } from "../mesh/mesh-lines.ts";
import type { Topology } from "../mesh/topology.ts";
import { type Place, project, type View } from "./picking.ts";
import type { Shell } from "./shell.ts";

/** Pixels: further away than this is a miss. */
const REACH = 12;
/** Pixels per unit of normalised depth, as for points: prefers the near side. */
const DEPTH_COST = 1500;

/** The edge nearest to a pixel; null if none is within reach. */
function pickEdge(
  points: Float32Array,
  { edges }: Topology,
  { x, y }: Place,
  view: View,
): Edge | null {
  const seen = Array.from({ length: points.length / 3 }, (_, v) => project(points, v, view));
  let found: Edge | null = null;
  let lowest = Number.POSITIVE_INFINITY;
  for (let e = 0; e < edges.length; e += 2) {
    const [from, to] = [edges[e] ?? 0, edges[e + 1] ?? 0];
    const [a, b] = [seen[from], seen[to]];
    if (!a || !b) continue;
    const [ux, uy] = [b.x - a.x, b.y - a.y];
    const along = ((x - a.x) * ux + (y - a.y) * uy) / (ux * ux + uy * uy || 1);
    const t = Math.min(1, Math.max(0, along));
    const distance = Math.hypot(a.x + t * ux - x, a.y + t * uy - y);
    const cost = distance + (a.depth + t * (b.depth - a.depth)) * DEPTH_COST;
    if (distance > REACH || cost >= lowest) continue;
    lowest = cost;
    found = [from, to];
  }
  return found;
}

/** The points; null beside every edge. */
export function pickLine(shell: Shell, place: Place, ring: boolean, view: View): number[] | null {
  const { base, current, offsets, vertices, topology, drawn } = shell;
  const edge = pickEdge(current, drawn, place, view);
  const mesh = { points: base, offsets, vertices, topology };
  return edge && (ring ? ringThrough : lineThrough)(mesh, edge);
}
