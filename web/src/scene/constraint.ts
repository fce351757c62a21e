// SPDX-License-Identifier: MIT
// Where a ray through the pointer meets the line, plane or screen plane that a drag is held to.
import { Plane, type Ray, Vector3 } from "three";

/** A line through the start of the drag, or the plane across it; unit direction. */
export interface Held {
  readonly direction: Vector3;
  readonly plane: boolean;
}

/** An arrow or small plane that was taken hold of. */
export interface Arrow extends Held {
  /** Where it stands, display coordinates. */
  readonly at: Vector3;
}

/** A plane seen more edge-on than this would throw points to the horizon. */
const EDGE_ON = 0.08;

/** Cosine from which a surface lies rather than stands: 45 degrees. */
const LYING = Math.SQRT1_2;
/** Sine of 20 degrees: a line nearer to the view than that says little about how far along. */
const SEEN = 0.34;

/**
 * What a drag is held to that is held to nothing else: up where the surface lies, its normal where
 * it stands. Null, for the plane of the screen, where that points at the viewer.
 */
export function usualLine(normal: Vector3, view: Vector3): Held | null {
  const direction = Math.abs(normal.z) < LYING ? normal : new Vector3(0, 0, 1);
  return Math.sqrt(1 - direction.dot(view) ** 2) < SEEN ? null : { direction, plane: false };
}

/** The point of the line through `start` nearest to the ray; null where the two run together. */
function onLine(ray: Ray, start: Vector3, direction: Vector3): Vector3 | null {
  const apart = ray.origin.clone().sub(start);
  const cosine = ray.direction.dot(direction);
  const sine = 1 - cosine * cosine;
  if (sine < EDGE_ON * EDGE_ON) return null;
  const along = (apart.dot(direction) - cosine * apart.dot(ray.direction)) / sine;
  return start.clone().addScaledVector(direction, along);
}

function onPlane(ray: Ray, start: Vector3, normal: Vector3): Vector3 | null {
  const plane = new Plane().setFromNormalAndCoplanarPoint(normal, start);
  return ray.intersectPlane(plane, new Vector3());
}

/** `view`: where the camera looks; the plane of a free drag. */
export function meet(ray: Ray, start: Vector3, held: Held | null, view: Vector3): Vector3 | null {
  if (!held) return onPlane(ray, start, view);
  if (!held.plane) return onLine(ray, start, held.direction);
  if (Math.abs(ray.direction.dot(held.direction)) >= EDGE_ON) {
    return onPlane(ray, start, held.direction);
  }
  const place = onPlane(ray, start, view);
  if (!place) return null;
  const off = place.clone().sub(start).dot(held.direction);
  return place.addScaledVector(held.direction, -off);
}

/** Rounds an offset to whole steps along each direction. */
export function snapOffset(offset: Vector3, step: number, directions: readonly Vector3[]): Vector3 {
  const snapped = new Vector3();
  for (const direction of directions) {
    snapped.addScaledVector(direction, Math.round(offset.dot(direction) / step) * step);
  }
  return snapped;
}
