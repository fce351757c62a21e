// SPDX-License-Identifier: MIT
// Points of a mesh in the order in which its edges join them.
import { neighboursOf } from "./mesh-lines.ts";
import type { Topology } from "./topology.ts";

/**
 * All of `points` along edges, each once, from the end with the smaller number; a closed one repeats
 * its first. null where they are no such line: in pieces, branching, or fewer than two.
 */
export function polylineOf(topology: Topology, points: readonly number[]): number[] | null {
  const chosen = new Set(points);
  const beside = (vertex: number): number[] =>
    neighboursOf(topology, vertex).filter((other) => chosen.has(other));
  const ordered = [...chosen].sort((a, b) => a - b);
  const ends: number[] = [];
  for (const vertex of ordered) {
    const count = beside(vertex).length;
    if (count < 1 || count > 2) return null;
    if (count === 1) ends.push(vertex);
  }
  if (ordered.length < 2) return null;
  let at = ends[0] ?? ordered[0];
  const line: number[] = [];
  const passed = new Set<number>();
  while (at !== undefined) {
    line.push(at);
    passed.add(at);
    at = beside(at).find((other) => !passed.has(other));
  }
  if (line.length !== ordered.length) return null;
  return ends.length === 0 ? [...line, ...line.slice(0, 1)] : line;
}
