// SPDX-License-Identifier: MIT
// Where the view looks from, as part of what is shared and kept.
import type { Point } from "./design.ts";

/** Display coordinates. */
export interface Camera {
  readonly position: Point;
  readonly target: Point;
}

export interface CameraPort {
  read(): Camera;
  place(camera: Camera): void;
}

let port: CameraPort | null = null;
/** Placed as soon as there is a view. */
let awaited: Camera | null = null;

/** The viewport says how to read and place its camera; null when it goes. */
export function provideCamera(given: CameraPort | null): void {
  port = given;
  if (port && awaited) port.place(awaited);
  awaited = null;
}

export const readCamera = (): Camera | null => port?.read() ?? null;

export function placeCamera(camera: Camera | null): void {
  if (!camera) return;
  if (port) port.place(camera);
  else awaited = camera;
}
