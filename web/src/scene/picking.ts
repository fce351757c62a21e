// SPDX-License-Identifier: MIT
import { type Camera, Matrix4, Vector3 } from "three";

/** Pixels: further away than this is a miss. */
const REACH = 18;
/** Pixels per unit of normalised depth: prefers the near side where points overlap. */
const DEPTH_COST = 1500;

export interface View {
  readonly camera: Camera;
  readonly width: number;
  readonly height: number;
}

const scratch = new Vector3();

/** Pixels from the top left of the canvas, and depth; null behind the camera. */
export function project(
  points: Float32Array,
  vertex: number,
  { camera, width, height }: View,
): { x: number; y: number; depth: number } | null {
  scratch.fromArray(points, 3 * vertex).project(camera);
  if (scratch.z < -1 || scratch.z > 1) return null;
  return { x: ((scratch.x + 1) / 2) * width, y: ((1 - scratch.y) / 2) * height, depth: scratch.z };
}

/** The vertex nearest to a pixel, in screen space; null if none is within reach. */
export function pickVertex(points: Float32Array, x: number, y: number, view: View): number | null {
  const matrix = new Matrix4().multiplyMatrices(
    view.camera.projectionMatrix,
    view.camera.matrixWorldInverse,
  );
  const e = matrix.elements;
  const [ex, ey] = [(2 * x) / view.width - 1, 1 - (2 * y) / view.height];
  let best: number | null = null;
  let lowest = Number.POSITIVE_INFINITY;
  for (let v = 0; v < points.length / 3; ++v) {
    const px = points[3 * v] ?? 0;
    const py = points[3 * v + 1] ?? 0;
    const pz = points[3 * v + 2] ?? 0;
    const w = (e[3] ?? 0) * px + (e[7] ?? 0) * py + (e[11] ?? 0) * pz + (e[15] ?? 0);
    if (w <= 0) continue;
    const cx = ((e[0] ?? 0) * px + (e[4] ?? 0) * py + (e[8] ?? 0) * pz + (e[12] ?? 0)) / w;
    const cy = ((e[1] ?? 0) * px + (e[5] ?? 0) * py + (e[9] ?? 0) * pz + (e[13] ?? 0)) / w;
    const distance = Math.hypot((cx - ex) * view.width, (cy - ey) * view.height) / 2;
    if (distance > REACH) continue;
    const cz = ((e[2] ?? 0) * px + (e[6] ?? 0) * py + (e[10] ?? 0) * pz + (e[14] ?? 0)) / w;
    const cost = distance + cz * DEPTH_COST;
    if (cost < lowest) {
      lowest = cost;
      best = v;
    }
  }
  return best;
}
