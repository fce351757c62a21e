// SPDX-License-Identifier: MIT
// Where points are on screen, and which lies under a pixel.
import { type Camera, Matrix4, Vector3 } from "three";
import { row, type Topology } from "../mesh/topology.ts";

/** Pixels: further away than this is a miss, for a mouse and for a finger. */
const REACH = { fine: 18, coarse: 30 };
/** Nearer than this is always a hit. */
const SURE = { fine: 6, coarse: 20 };
/** Share of a point's edges on screen that belongs to it; the middle of a panel is the panel's. */
const SHARE = 0.6;
/** Pixels per unit of normalised depth: prefers the near side where points overlap. */
const DEPTH_COST = 1500;

export interface View {
  readonly camera: Camera;
  readonly width: number;
  readonly height: number;
}

/** Pixels from the top left of the canvas. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

/** Pixels from the top left of the canvas. */
export interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** What can be picked. */
export interface Points {
  /** Display coordinates. */
  readonly current: Float32Array;
  readonly topology: Topology;
  readonly isShown: (vertex: number) => boolean;
}

const scratch = new Vector3();

/** Where a point is on screen; null behind the camera. */
export function project(
  points: Float32Array,
  vertex: number,
  { camera, width, height }: View,
): (Place & { readonly depth: number }) | null {
  scratch.fromArray(points, 3 * vertex).project(camera);
  if (scratch.z < -1 || scratch.z > 1) return null;
  return { x: ((scratch.x + 1) / 2) * width, y: ((1 - scratch.y) / 2) * height, depth: scratch.z };
}

/** Calls `seen` with pixels and depth of every point before the camera. */
export function eachOnScreen(
  points: Float32Array,
  { camera, width, height }: View,
  seen: (vertex: number, x: number, y: number, depth: number) => void,
): void {
  const matrix = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  const e = matrix.elements;
  const along = (k: number, x: number, y: number, z: number): number =>
    (e[k] ?? 0) * x + (e[k + 4] ?? 0) * y + (e[k + 8] ?? 0) * z + (e[k + 12] ?? 0);
  for (let v = 0; v < points.length / 3; ++v) {
    const [px, py, pz] = [points[3 * v] ?? 0, points[3 * v + 1] ?? 0, points[3 * v + 2] ?? 0];
    const w = along(3, px, py, pz);
    if (w <= 0) continue;
    const x = ((along(0, px, py, pz) / w + 1) / 2) * width;
    const y = ((1 - along(1, px, py, pz) / w) / 2) * height;
    seen(v, x, y, along(2, px, py, pz) / w);
  }
}

/** Mean length in pixels of the edges at a point. */
function spacing(points: Float32Array, vertex: number, topology: Topology, view: View): number {
  const at = project(points, vertex, view);
  const ends = row(topology.edgeEnds, vertex);
  let sum = 0;
  for (const end of ends) {
    const to = project(points, topology.edges[end ^ 1] ?? vertex, view);
    if (at && to) sum += Math.hypot(to.x - at.x, to.y - at.y);
  }
  return ends.length > 0 ? sum / ends.length : Number.POSITIVE_INFINITY;
}

/** The vertex nearest to a pixel, in screen space; null if none is within reach. */
export function pickVertex(
  { current: points, topology, isShown }: Points,
  { x, y }: Place,
  coarse: boolean,
  view: View,
): number | null {
  const size = coarse ? "coarse" : "fine";
  let best: number | null = null;
  let away = 0;
  let lowest = Number.POSITIVE_INFINITY;
  eachOnScreen(points, view, (v, px, py, depth) => {
    const distance = Math.hypot(px - x, py - y);
    const cost = distance + depth * DEPTH_COST;
    if (distance > REACH[size] || cost >= lowest || !isShown(v)) return;
    lowest = cost;
    best = v;
    away = distance;
  });
  if (best === null || away <= SURE[size]) return best;
  return away <= SHARE * spacing(points, best, topology, view) ? best : null;
}
