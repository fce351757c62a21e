// SPDX-License-Identifier: MIT
// Where the view looks from, as part of what is shared and kept.

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
}

const own = kept((): Own => ({ port: null, awaited: null }));

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
