// SPDX-License-Identifier: MIT
// Which points an edit's reach covers, and the line beyond which nothing moves.
import type { Polygons } from "./display-mesh.ts";
import { row, type Topology } from "./topology.ts";
import { panelAt } from "./triangulation.ts";

export interface ReachLimit {
  /** Face rings; 0: no limit. */
  readonly rings: number;
  /** Straight from a handle, display units; 0: no limit. */
  readonly length: number;
}

type Structure = Polygons & { readonly topology: Topology };

export const facesAt = ({ topology, offsets }: Structure, vertex: number): number[] =>
  [...row(topology.corners, vertex)].map((corner) => panelAt(offsets, corner));

/** Face rings from the nearest of `seeds` to each point within the limit; seeds are at 0. */
export function ringsWithin(
  mesh: Structure,
  seeds: readonly number[],
  { rings, length }: ReachLimit,
): Map<number, number> {
  const { display, offsets, vertices } = mesh;
  const apart = (v: number, w: number): number =>
    Math.hypot(...[0, 1, 2].map((c) => (display[3 * v + c] ?? 0) - (display[3 * w + c] ?? 0)));
  const near = (v: number): boolean => length === 0 || seeds.some((w) => apart(v, w) <= length);
  const found = new Map(seeds.map((seed) => [seed, 0]));
  let front = [...found.keys()];
  for (let ring = 1; front.length > 0 && (rings === 0 || ring <= rings); ++ring) {
    const next: number[] = [];
    for (const face of new Set(front.flatMap((v) => facesAt(mesh, v)))) {
      for (const v of vertices.subarray(offsets[face] ?? 0, offsets[face + 1] ?? 0)) {
        if (found.has(v) || !near(v)) continue;
        found.set(v, ring);
        next.push(v);
      }
    }
    front = next;
  }
  return found;
}

/** Both ends of each edge around the panels that `covered` points can change. */
export function outlineOf(mesh: Structure, covered: Iterable<number>): number[] {
  const { offsets, vertices } = mesh;
  const faces = new Set([...covered].flatMap((v) => facesAt(mesh, v)));
  const open = new Map<string, readonly [number, number]>();
  for (const face of faces) {
    const corners = vertices.subarray(offsets[face] ?? 0, offsets[face + 1] ?? 0);
    corners.forEach((v, k) => {
      const w = corners[(k + 1) % corners.length] ?? v;
      const key = v < w ? `${v},${w}` : `${w},${v}`;
      if (!open.delete(key)) open.set(key, [v, w]);
    });
  }
  return [...open.values()].flat();
}
