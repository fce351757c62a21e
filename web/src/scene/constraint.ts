// SPDX-License-Identifier: MIT
// How far a ray through the pointer goes along the line, plane or screen plane that a drag is held to.
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

/** A plane seen more edge-on than this, or a place this near to where a line vanishes, would throw points to
 * the horizon. */
const EDGE_ON = 0.08;

/** Cosine from which a surface lies rather than stands: 45 degrees. */
const LYING = Math.SQRT1_2;
/** Sine of 20 degrees: a line nearer to the view than that says little about how far along. */
const SEEN = 0.34;

/**
 * What a drag is held to that is held to nothing else: up where the surface lies, its normal where
 * it stands. Null, for the plane of the screen, where that points at the viewer.
 * @param sight from the viewer to the point, unit length
 */
export function usualLine(normal: Vector3, sight: Vector3): Held | null {
  const direction = Math.abs(normal.z) < LYING ? normal : new Vector3(0, 0, 1);
  return Math.sqrt(1 - direction.dot(sight) ** 2) < SEEN ? null : { direction, plane: false };
}

/** Where a direction meets the picture: the plane at depth 1. */
const onPicture = (direction: Vector3, view: Vector3): Vector3 =>
  direction.clone().divideScalar(direction.dot(view));

/** A line and the pointer's way in the picture, the plane at depth 1. */
interface Pictured {
  /** Of the line's direction, once it is at depth 1. */
  readonly drawn: Vector3;
  readonly way: Vector3;
}

function pictured(
  press: Ray,
  ray: Ray,
  start: Vector3,
  direction: Vector3,
  view: Vector3,
): Pictured {
  const at = onPicture(start.clone().sub(ray.origin), view);
  // Once the camera has moved the point is held at its own place.
  const from = press.origin.equals(ray.origin) ? onPicture(press.direction, view) : at;
  return {
    drawn: direction.clone().addScaledVector(at, -direction.dot(view)),
    way: onPicture(ray.direction, view).sub(from),
  };
}

/** How far the pointer went aside of the picture of the line that holds the point, at depth 1. */
export function aside(
  press: Ray,
  ray: Ray,
  start: Vector3,
  { direction }: Held,
  view: Vector3,
): number {
  const { drawn, way } = pictured(press, ray, start, direction, view);
  return way.addScaledVector(drawn, -way.dot(drawn) / drawn.lengthSq()).length();
}

/**
 * How far along the line through `start` the point goes, so that on screen it goes as far along the line's
 * picture as the pointer does: further for each pixel, up to where the line vanishes. Null beyond, and where the
 * line points at the viewer.
 */
function along(press: Ray, ray: Ray, start: Vector3, direction: Vector3, view: Vector3) {
  const apart = start.clone().sub(ray.origin);
  const cosine = apart.dot(direction) / apart.length();
  if (1 - cosine * cosine < EDGE_ON * EDGE_ON) return null;
  const { drawn, way } = pictured(press, ray, start, direction, view);
  const length = drawn.length();
  const moved = way.dot(drawn) / length;
  const left = length - moved * direction.dot(view);
  return left < EDGE_ON * length ? null : (moved * apart.dot(view)) / left;
}

function onPlane(ray: Ray, start: Vector3, normal: Vector3): Vector3 | null {
  const plane = new Plane().setFromNormalAndCoplanarPoint(normal, start);
  return ray.intersectPlane(plane, new Vector3());
}

function meet(ray: Ray, start: Vector3, held: Held | null, view: Vector3): Vector3 | null {
  if (!held) return onPlane(ray, start, view);
  if (Math.abs(ray.direction.dot(held.direction)) >= EDGE_ON) {
    return onPlane(ray, start, held.direction);
  }
  const place = onPlane(ray, start, view);
  if (!place) return null;
  const off = place.clone().sub(start).dot(held.direction);
  return place.addScaledVector(held.direction, -off);
}

/**
 * The way of a point at `start` while the pointer goes from one ray to another; null where what holds it says of
 * no place how far that is.
 * @param view where the camera looks; the plane of a free drag
 */
export function dragged(
  press: Ray,
  ray: Ray,
  start: Vector3,
  held: Held | null,
  view: Vector3,
): Vector3 | null {
  if (held && !held.plane) {
    const length = along(press, ray, start, held.direction, view);
    return length === null ? null : held.direction.clone().multiplyScalar(length);
  }
  const to = meet(ray, start, held, view);
  const from = meet(press, start, held, view);
  return to && from && to.sub(from);
}

/** Rounds an offset to whole steps along each direction. */
export function snapOffset(offset: Vector3, step: number, directions: readonly Vector3[]): Vector3 {
  const snapped = new Vector3();
  for (const direction of directions) {
    snapped.addScaledVector(direction, Math.round(offset.dot(direction) / step) * step);
  }
  return snapped;
}
