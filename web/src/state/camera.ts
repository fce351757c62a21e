// SPDX-License-Identifier: MIT
// Where the view looks from, as part of what is shared and kept; and what can be seen from there.

import type { Camera } from "../design/camera.ts";
import { kept, type Page } from "./page.ts";

export interface CameraPort {
  read(): Camera;
  place(camera: Camera): void;
}

interface Own {
  port: CameraPort | null;
  /** Placed as soon as there is a view. */
  awaited: Camera | null;
  sees: ((vertex: number) => boolean) | null;
}

const own = kept((): Own => ({ port: null, awaited: null, sees: null }));

/** The viewport says how to read and place its camera; null when it goes. */
export function provideCamera(page: Page, given: CameraPort | null): void {
  const view = own(page);
  view.port = given;
  if (view.port && view.awaited) view.port.place(view.awaited);
  view.awaited = null;
}

export const readCamera = (page: Page): Camera | null => own(page).port?.read() ?? null;

export function placeCamera(page: Page, camera: Camera | null): void {
  if (!camera) return;
  const view = own(page);
  if (view.port) view.port.place(camera);
  else view.awaited = camera;
}

/** The viewport says which points nothing hides; null when it goes. */
export function provideSight(page: Page, sees: ((vertex: number) => boolean) | null): void {
  own(page).sees = sees;
}

/** Whether a point is in view, with nothing before it; without a view every point is. */
export const isSeen = (page: Page, vertex: number): boolean => own(page).sees?.(vertex) ?? true;
