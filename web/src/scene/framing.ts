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

/** Share of the room that a fitted subject fills. */
const FILL = 0.86;

export interface Standpoint {
  readonly position: Vector3;
  /** What the camera looks at and turns about. */
  readonly target: Vector3;
}

/** What a camera sees along one direction, wherever it stands. */
export interface Sight {
  /** To the right and upwards on screen, and from the subject to the camera; of length 1. */
  readonly right: Vector3;
  readonly above: Vector3;
  readonly towards: Vector3;
  /** Pixels of the view, and from its top to the camera's axis. */
  readonly width: number;
  readonly height: number;
  readonly axis: number;
  /** Tangent of the angle of one pixel at the axis. */
  readonly slope: number;
}

/** Tangent of the angle from a camera's axis to the upper end of its view. */
export const slopeOf = (fov: number): number => Math.tan((fov * Math.PI) / 360);

/** Tangent of the angle of one pixel at the axis. */
export const pixelSlope = ({ fov, view }: PerspectiveCamera): number =>
  (2 * slopeOf(fov)) / (view?.height ?? 1);

export function sightOf(camera: PerspectiveCamera, towards: Vector3): Sight {
  const { up, view } = camera;
  const { width = 1, height = 1, offsetY = 0 } = view ?? {};
  const right = new Vector3().crossVectors(up, towards).normalize();
  const above = new Vector3().crossVectors(towards, right);
  const [axis, slope] = [height / 2 - offsetY, pixelSlope(camera)];
  return { right, above, towards, width, height, axis, slope };
}

/** Pixels along the sides of the view that a subject is kept out of. */
export interface Margins {
  readonly left: number;
  readonly top: number;
  readonly bottom: number;
}

/** Tangents up to which a subject may reach on the two sides of the axis. */
function reach(before: number, behind: number, slope: number): readonly [number, number] {
  const [middle, half] = [(behind - before) / 2, (FILL * (behind + before)) / 2];
  return [(half - middle) * slope, (half + middle) * slope];
}

/**
 * The nearest standpoint from which a camera sees every point within the margins, in the middle of
 * the room they leave. In the camera's own axes each side of the room is a half-space for its
 * position, so the answer is closed.
 */
export function standpoint(points: Float32Array, sight: Sight, margins: Margins): Standpoint {
  const { right, above, towards, width, height, axis, slope } = sight;
  const [toLeft, toRight] = reach(width / 2 - margins.left, width / 2, slope);
  const [toTop, toBottom] = reach(axis - margins.top, height - axis - margins.bottom, slope);
  const sides = { right: -Infinity, left: -Infinity, top: -Infinity, bottom: -Infinity };
  const point = new Vector3();
  for (let v = 0; v < points.length / 3; ++v) {
    point.fromArray(points, 3 * v);
    const [a, b, c] = [point.dot(right), point.dot(above), point.dot(towards)];
    sides.right = Math.max(sides.right, a + toRight * c);
    sides.left = Math.max(sides.left, -a + toLeft * c);
    sides.top = Math.max(sides.top, b + toTop * c);
    sides.bottom = Math.max(sides.bottom, -b + toBottom * c);
  }
  const across = (sides.right + sides.left) / (toRight + toLeft);
  const upright = (sides.top + sides.bottom) / (toTop + toBottom);
  const middle = new Box3().setFromArray(points).getCenter(new Vector3()).dot(towards);
  const away = Math.max(across, upright, middle + 0.5);
  const aside = (sides.right - sides.left + (toLeft - toRight) * away) / 2;
  const up = (sides.top - sides.bottom + (toBottom - toTop) * away) / 2;
  const place = (depth: number): Vector3 =>
    new Vector3()
      .addScaledVector(right, aside)
      .addScaledVector(above, up)
      .addScaledVector(towards, depth);
  return { position: place(away), target: place(middle) };
}
