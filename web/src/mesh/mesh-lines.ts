// SPDX-License-Identifier: MIT
// Lines of a mesh: along its edges, straight on at every point, and across the edges of a strip.
import { row, type Topology } from "./topology.ts";
import { panelAt } from "./triangulation.ts";
import { dot, type Vector } from "./vector.ts";

export interface LinedMesh {
  /** Three coordinates per point, in any scale. */
  readonly points: ArrayLike<number>;
  readonly offsets: Int32Array;
  readonly vertices: Int32Array;
  readonly topology: Topology;
}

/** Cosine of the bend at which one side of the boundary ends and the next begins. */
const CORNER = 0.5;

/** Two neighbouring points. */
export type Edge = readonly [number, number];

export function neighboursOf({ edges, edgeEnds }: Topology, vertex: number): number[] {
  return Array.from(row(edgeEnds, vertex), (end) => edges[end ^ 1] ?? vertex);
}

function cornersOf({ offsets, vertices }: LinedMesh, panel: number): Int32Array {
  return vertices.subarray(offsets[panel] ?? 0, offsets[panel + 1] ?? 0);
}

/** The panels that an edge borders: two within the mesh, one at its boundary. */
function panelsAlong(mesh: LinedMesh, [a, b]: Edge): number[] {
  const panels = Array.from(row(mesh.topology.corners, a), (c) => panelAt(mesh.offsets, c));
  return panels.filter((panel) => {
    const corners = cornersOf(mesh, panel);
    const at = corners.indexOf(a);
    const around = corners.length;
    return corners[(at + 1) % around] === b || corners[(at + around - 1) % around] === b;
  });
}

/** Cosine of the bend from one edge into the next. */
function straightness({ points }: LinedMesh, a: number, b: number, c: number): number {
  const along = (from: number, to: number): Vector => {
    const at = (k: number): number => (points[3 * to + k] ?? 0) - (points[3 * from + k] ?? 0);
    return [at(0), at(1), at(2)];
  };
  const [u, v] = [along(a, b), along(b, c)];
  return dot(u, v) / (Math.hypot(...u) * Math.hypot(...v) || 1);
}

/**
 * The point that follows `b` on the line that comes from `a`: across the edge at `b` that shares no
 * panel with the one it comes by and has as many edges on either side; null where the line ends.
 */
function pointAfter(mesh: LinedMesh, [a, b]: Edge): number | null {
  const beside = panelsAlong(mesh, [a, b]);
  const border = beside.length === 1;
  if (!border && mesh.topology.boundary[b] === 1) return null;
  const ahead = neighboursOf(mesh.topology, b).filter((c) => {
    const panels = panelsAlong(mesh, [b, c]);
    return c !== a && !panels.some((p) => beside.includes(p)) && (panels.length === 1) === border;
  });
  if (ahead.length % 2 === 0) return null;
  const cosine = (c: number): number => straightness(mesh, a, b, c);
  const next = ahead.reduce((best, c) => (cosine(c) > cosine(best) ? c : best));
  return border && cosine(next) < CORNER ? null : next;
}

/** From `edge` on, to where the line ends or comes back to it. */
function pointsAhead(mesh: LinedMesh, edge: Edge): number[] {
  const way: number[] = [];
  let [a, b] = edge;
  for (let steps = mesh.topology.edges.length / 2; steps > 0; --steps) {
    const next = pointAfter(mesh, [a, b]);
    if (next === null) break;
    [a, b] = [b, next];
    if (a === edge[0] && b === edge[1]) break;
    way.push(next);
  }
  return way;
}

/** The points of the line of edges that goes through an edge. */
export function lineThrough(mesh: LinedMesh, [a, b]: Edge): number[] {
  return [...new Set([...pointsAhead(mesh, [b, a]).reverse(), a, b, ...pointsAhead(mesh, [a, b])])];
}

/** The edge across a quad from one of its edges, the same way round; null in another panel. */
function edgeAcross(mesh: LinedMesh, panel: number, [a, b]: Edge): Edge | null {
  const corners = cornersOf(mesh, panel);
  if (corners.length !== 4) return null;
  const at = corners.indexOf(a);
  const forward = corners[(at + 1) % 4] === b;
  const [c, d] = [corners[(at + (forward ? 3 : 1)) % 4], corners[(at + 2) % 4]];
  return c === undefined || d === undefined ? null : [c, d];
}

/** The points of the strip of quads that goes across an edge, both its sides. */
export function ringThrough(mesh: LinedMesh, edge: Edge): number[] {
  const found = new Set<number>(edge);
  for (const first of panelsAlong(mesh, edge)) {
    let [panel, at]: [number | undefined, Edge] = [first, edge];
    for (let steps = mesh.topology.edges.length / 2; panel !== undefined && steps > 0; --steps) {
      const across = edgeAcross(mesh, panel, at);
      if (!across || (across[0] === edge[0] && across[1] === edge[1])) break;
      for (const vertex of across) found.add(vertex);
      const passed: number = panel;
      panel = panelsAlong(mesh, across).find((other) => other !== passed);
      at = across;
    }
  }
  return [...found];
}
