// SPDX-License-Identifier: MIT
// What is on screen and from where it is seen: pixels, rays, and places on the structure.

import { signal } from "@preact/signals";
import { type Ray, Vector3 } from "three";
import type { Outcome } from "../state/action-queue.ts";
import type { Page } from "../state/page.ts";
import { type Place, project, type View } from "./picking.ts";
import type { Shell } from "./shell.ts";
import type { Stage } from "./stage.ts";
import { surfaceHit } from "./surface-hit.ts";

/** Pixels: the pointer still means the same place. */
const SAME = 1;
/** Share of the way from the eye: the panels at a point do not hide it. */
const TOUCHING = 1e-3;

export class Sight {
  readonly page: Page;
  readonly canvas: HTMLCanvasElement;
  readonly stage: Stage;
  /** The structure on the stage; null before there is one, and after the view is gone. */
  shell: Shell | null = null;
  /** Where a finger drags points, pixels of the canvas; null while none does. */
  readonly finger = signal<Place | null>(null);
  /** The latest of its drags: the point that led, and how it ends. */
  readonly lifted = signal<{ readonly vertex: number; readonly ended: Outcome } | null>(null);
  /** The last place on the surface that the wheel or a turn began at. */
  #approached: Vector3 | null = null;

  constructor(page: Page, canvas: HTMLCanvasElement, stage: Stage) {
    this.page = page;
    this.canvas = canvas;
    this.stage = stage;
  }

  view(): View {
    const { width, height } = this.canvas.getBoundingClientRect();
    return { camera: this.stage.camera, width, height };
  }

  rayThrough({ x, y }: Place): Ray {
    const { width, height } = this.view();
    return this.stage.rayThrough((2 * x) / width - 1, 1 - (2 * y) / height);
  }

  /** Whether a point is in view, with no panel before it. */
  sees(vertex: number): boolean {
    const [shell, view] = [this.shell, this.view()];
    const at = shell && project(shell.current, vertex, view);
    if (!shell || !at || at.x < 0 || at.y < 0 || at.x > view.width || at.y > view.height)
      return false;
    const ray = this.rayThrough(at);
    const way = new Vector3().fromArray(shell.current, 3 * vertex).distanceTo(ray.origin);
    const hit = surfaceHit(shell, ray);
    return !hit || hit.at.distanceTo(ray.origin) > (1 - TOUCHING) * way;
  }

  /** Where the point chosen last is; null if it is out of view. */
  leader(): Vector3 | null {
    const [shell, vertex] = [this.shell, this.page.selected.value];
    if (!shell || vertex === null) return null;
    const view = this.view();
    const at = project(shell.current, vertex, view);
    if (!at || at.x < 0 || at.y < 0 || at.x > view.width || at.y > view.height) return null;
    return new Vector3().fromArray(shell.current, 3 * vertex);
  }

  /** What lies under a pixel; zooming to it keeps it there, so that one search does for a ride. */
  surfaceAt(place: Place): Vector3 | null {
    const view = this.view();
    const found = this.#approached;
    const seen = found && project(Float32Array.from(found.toArray()), 0, view);
    if (!seen || Math.hypot(seen.x - place.x, seen.y - place.y) > SAME) {
      const hit = this.shell && surfaceHit(this.shell, this.rayThrough(place));
      this.#approached = hit?.at ?? null;
    }
    return this.#approached;
  }
}
