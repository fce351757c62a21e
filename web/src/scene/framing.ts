// SPDX-License-Identifier: MIT
// Where a camera must stand.
import { Box3, type PerspectiveCamera, Sphere, Vector3 } from "three";

export type ViewName = "Perspective" | "Top" | "Front" | "Side";

/** From the model to the camera. */
export const DIRECTIONS: Readonly<Record<ViewName, readonly [number, number, number]>> = {
  Perspective: [-0.52, -0.92, 0.62],
  Top: [0, -0.001, 1],
  Front: [0, -1, 0],
  Side: [1, 0, 0],
};

/**
 * Holds every mesh in display coordinates, which span 10 about the origin. The renderer sorts by its
 * middle; left to itself it would look at every point, which takes half a second for a million.
 */
export const displaySphere = (): Sphere => new Sphere(new Vector3(), 5);

/** Share of the view that a fitted subject fills. */
const FILL = 0.86;

export interface Standpoint {
  readonly position: Vector3;
  /** What the camera looks at and turns about. */
  readonly target: Vector3;
}

/**
 * The nearest standpoint from which a camera that looks against `towards` sees every point in
 * the `free` share of the view's height about its axis, with equal margins left and right or above
 * and below. In the camera's own axes each side of the view is a half-space for its position, so
 * the answer is closed.
 */
export function standpoint(
  points: Float32Array,
  towards: Vector3,
  { fov, aspect, up }: PerspectiveCamera,
  free: number,
): Standpoint {
  const right = new Vector3().crossVectors(up, towards).normalize();
  const above = new Vector3().crossVectors(towards, right);
  const whole = Math.tan((fov * Math.PI) / 360) * FILL;
  const high = whole * free;
  const wide = whole * aspect;
  const sides = { right: -Infinity, left: -Infinity, top: -Infinity, bottom: -Infinity };
  const point = new Vector3();
  for (let v = 0; v < points.length / 3; ++v) {
    point.fromArray(points, 3 * v);
    const [a, b, c] = [point.dot(right), point.dot(above), point.dot(towards)];
    sides.right = Math.max(sides.right, a + wide * c);
    sides.left = Math.max(sides.left, -a + wide * c);
    sides.top = Math.max(sides.top, b + high * c);
    sides.bottom = Math.max(sides.bottom, -b + high * c);
  }
  const across = (sides.right + sides.left) / (2 * wide);
  const upright = (sides.top + sides.bottom) / (2 * high);
  const middle = new Box3().setFromArray(points).getCenter(new Vector3()).dot(towards);
  const place = (depth: number): Vector3 =>
    new Vector3()
      .addScaledVector(right, (sides.right - sides.left) / 2)
      .addScaledVector(above, (sides.top - sides.bottom) / 2)
      .addScaledVector(towards, depth);
  return { position: place(Math.max(across, upright, middle + 0.5)), target: place(middle) };
}
