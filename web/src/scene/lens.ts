// SPDX-License-Identifier: MIT
// In perspective, or nearly in parallel: a lens so long, from so far away, that the difference is
// about a pixel. It stays one kind of camera, so that nothing else has to know.
import { type PerspectiveCamera, Vector3 } from "three";
import { DIRECTIONS, type Standpoint, slopeOf, type ViewName } from "./framing.ts";

/** Degrees. */
export const WIDE = 28;
const LONG = 0.5;

/** Display units: clipping planes of the wide lens. */
export const CLIP = { near: 0.1, far: 400 } as const;

/** How many times as far away a camera stands as with the wide lens, for the same picture. */
export const stretchOf = ({ fov }: PerspectiveCamera): number => slopeOf(WIDE) / slopeOf(fov);

/** `camera` moves on its axis so that what lies about `target` keeps its size. */
export function changeLens(camera: PerspectiveCamera, target: Vector3, parallel: boolean): void {
  const fov = parallel ? LONG : WIDE;
  if (camera.fov === fov) return;
  const before = stretchOf(camera);
  camera.fov = fov;
  camera.position
    .sub(target)
    .multiplyScalar(stretchOf(camera) / before)
    .add(target);
  camera.updateProjectionMatrix();
}

/**
 * Clipping planes that leave as many steps of depth to a pixel's width as the wide lens has; before
 * half of the way to the target, for a long lens comes close to what it shows large.
 */
export function clip(camera: PerspectiveCamera, target: Vector3): void {
  const stretch = stretchOf(camera);
  const half = camera.position.distanceTo(target) / 2;
  const near = stretch === 1 ? CLIP.near : Math.min(CLIP.near * stretch ** 2, half);
  const far = CLIP.far * stretch;
  if (near === camera.near && far === camera.far) return;
  Object.assign(camera, { near, far });
  camera.updateProjectionMatrix();
}

/** The standpoint of the wide lens that gives the same picture about the target. */
export function withWideLens(camera: PerspectiveCamera, target: Vector3): Standpoint {
  const arm = camera.position.clone().sub(target).divideScalar(stretchOf(camera));
  return { position: arm.add(target), target };
}

const PARALLEL: readonly ViewName[] = ["Top", "Front", "Side"];

export const isParallel = (name: ViewName): boolean => PARALLEL.includes(name);

/** Standpoints are kept to a thousandth of a display unit. */
const ROUNDED = 0.002;

/** The view whose direction a standpoint has, of those in parallel; null if it is none of them. */
export function parallelDirection({ position, target }: Standpoint): Vector3 | null {
  const arm = position.clone().sub(target);
  for (const name of PARALLEL) {
    const direction = new Vector3(...DIRECTIONS[name]).normalize();
    if (arm.distanceTo(direction.clone().multiplyScalar(arm.length())) < ROUNDED) return direction;
  }
  return null;
}
