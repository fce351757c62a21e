// SPDX-License-Identifier: MIT
// Pressing a point selects it; pressing and moving drags it in the plane of the screen.
import { Plane, Raycaster, Vector2, Vector3 } from "three";
import type { Gizmo } from "./gizmo.ts";
import { pickVertex, type View } from "./picking.ts";
import type { Stage } from "./stage.ts";

/** Pixels a press may wander and still be a click. */
const CLICK_SLACK = 3;

export interface PointerEvents {
  readonly points: () => Float32Array | null;
  readonly hover: (vertex: number | null) => void;
  readonly select: (vertex: number | null) => void;
  readonly drag: (vertex: number, place: Vector3) => void;
  readonly release: () => void;
  readonly abandon: () => void;
}

interface Press {
  readonly vertex: number | null;
  readonly x: number;
  readonly y: number;
  readonly plane: Plane;
  readonly offset: Vector3;
  moved: boolean;
}

export class PointerTool {
  readonly #canvas: HTMLCanvasElement;
  readonly #stage: Stage;
  readonly #gizmo: Gizmo;
  readonly #events: PointerEvents;
  readonly #ray = new Raycaster();
  readonly #off = new AbortController();
  #press: Press | null = null;

  constructor(canvas: HTMLCanvasElement, stage: Stage, gizmo: Gizmo, events: PointerEvents) {
    this.#canvas = canvas;
    this.#stage = stage;
    this.#gizmo = gizmo;
    this.#events = events;
    const { signal } = this.#off;
    // Before the camera controls see it: a press on a point must not turn the view.
    canvas.addEventListener("pointerdown", (e) => this.#down(e), { capture: true, signal });
    canvas.addEventListener("pointermove", (e) => this.#move(e), { signal });
    canvas.addEventListener("pointerup", (e) => this.#up(e), { signal });
    canvas.addEventListener("pointercancel", () => this.abandon(), { signal });
    canvas.addEventListener("pointerleave", () => this.#events.hover(null), { signal });
  }

  get dragging(): boolean {
    return this.#press?.moved === true && this.#press.vertex !== null;
  }

  /** Gives the drag up; the design goes back to where it was. */
  abandon(): void {
    const wasDragging = this.dragging;
    this.#press = null;
    this.#stage.orbit.enabled = true;
    if (wasDragging) this.#events.abandon();
  }

  dispose(): void {
    this.#off.abort();
  }

  #view(): View {
    const { width, height } = this.#canvas.getBoundingClientRect();
    return { camera: this.#stage.camera, width, height };
  }

  #pick(event: PointerEvent): number | null {
    const points = this.#events.points();
    const box = this.#canvas.getBoundingClientRect();
    return points
      ? pickVertex(points, event.clientX - box.left, event.clientY - box.top, this.#view())
      : null;
  }

  #down(event: PointerEvent): void {
    if (event.button !== 0 || !event.isPrimary || this.#gizmo.holds(event, this.#canvas)) return;
    const vertex = this.#pick(event);
    const points = this.#events.points();
    const at = new Vector3();
    if (vertex !== null && points) at.fromArray(points, 3 * vertex);
    const normal = this.#stage.camera.getWorldDirection(new Vector3());
    const plane = new Plane().setFromNormalAndCoplanarPoint(normal, at);
    const offset = at.sub(this.#onPlane(event, plane) ?? at);
    this.#press = { vertex, x: event.clientX, y: event.clientY, plane, offset, moved: false };
    if (vertex === null) return;
    this.#stage.orbit.enabled = false;
    this.#canvas.setPointerCapture(event.pointerId);
  }

  #move(event: PointerEvent): void {
    const press = this.#press;
    if (!press) {
      if (!this.#gizmo.dragging && event.pointerType === "mouse" && event.buttons === 0) {
        this.#events.hover(this.#pick(event));
      }
      return;
    }
    const far = Math.hypot(event.clientX - press.x, event.clientY - press.y) > CLICK_SLACK;
    press.moved ||= far;
    if (press.vertex === null || !press.moved) return;
    const place = this.#onPlane(event, press.plane);
    if (place) this.#events.drag(press.vertex, place.add(press.offset));
  }

  #up(event: PointerEvent): void {
    const press = this.#press;
    this.#press = null;
    this.#stage.orbit.enabled = true;
    if (!press || event.button !== 0) return;
    if (!press.moved) this.#events.select(press.vertex);
    else if (press.vertex !== null) this.#events.release();
  }

  #onPlane(event: PointerEvent, plane: Plane): Vector3 | null {
    const box = this.#canvas.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * 2 - 1;
    const y = 1 - ((event.clientY - box.top) / box.height) * 2;
    this.#ray.setFromCamera(new Vector2(x, y), this.#stage.camera);
    return this.#ray.ray.intersectPlane(plane, new Vector3());
  }
}
