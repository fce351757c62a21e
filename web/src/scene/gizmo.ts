// SPDX-License-Identifier: MIT
import { Object3D, type Vector3 } from "three";
import { TransformControls } from "three/addons/controls/TransformControls.js";
import type { Stage } from "./stage.ts";

export interface DragEvents {
  readonly start: () => void;
  readonly move: (place: Vector3) => void;
  readonly end: () => void;
}

/** Arrows and planes at one point; display coordinates. */
export class Gizmo {
  readonly #controls: TransformControls;
  readonly #proxy = new Object3D();
  readonly #stage: Stage;

  constructor(stage: Stage, canvas: HTMLCanvasElement, events: DragEvents) {
    this.#stage = stage;
    this.#controls = new TransformControls(stage.camera, canvas);
    this.#controls.setSize(0.62);
    this.#controls.setColors("#C2453A", "#3C8A4E", "#2F5FD0", "#F2B134");
    this.#controls.addEventListener("change", () => stage.invalidate());
    this.#controls.addEventListener("dragging-changed", ({ value }) => {
      stage.orbit.enabled = !value;
      if (value) events.start();
      else events.end();
    });
    this.#controls.addEventListener("objectChange", () => events.move(this.#proxy.position));
    stage.scene.add(this.#proxy, this.#controls.getHelper());
  }

  get dragging(): boolean {
    return this.#controls.dragging;
  }

  /** Whether a press at this pixel would take hold of an arrow or plane. */
  holds(event: PointerEvent, canvas: HTMLCanvasElement): boolean {
    if (!this.#controls.object) return false;
    const box = canvas.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * 2 - 1;
    const y = 1 - ((event.clientY - box.top) / box.height) * 2;
    this.#controls.pointerHover(Object.assign(new PointerEvent("pointermove"), { x, y }));
    return this.#controls.axis !== null;
  }

  attach(x: number, y: number, z: number): void {
    if (this.#controls.dragging) return;
    this.#proxy.position.set(x, y, z);
    this.#proxy.updateMatrixWorld();
    if (!this.#controls.object) this.#controls.attach(this.#proxy);
    this.#stage.invalidate();
  }

  detach(): void {
    this.#controls.detach();
    this.#stage.invalidate();
  }

  setSnap(step: number | null): void {
    this.#controls.setTranslationSnap(step);
  }

  dispose(): void {
    this.#controls.dispose();
  }
}
