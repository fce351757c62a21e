// SPDX-License-Identifier: MIT
// Presses become clicks, drags of points, boxes or turns of the camera; with mouse, pen and touch.
import type { Ray } from "three";
import { readOnly } from "../state/store.ts";
import type { Held } from "./constraint.ts";
import type { DragSession } from "./drag-session.ts";
import type { Box, Place } from "./picking.ts";
import type { Stage } from "./stage.ts";

/** Pixels a press may wander and still be a click; fingers are less steady. */
const SLACK = { fine: 3, coarse: 8 };

/** What lies under a pixel that can be taken hold of. */
export interface Hold {
  readonly vertex: number;
  /** Set when an arrow or plane of the gizmo was hit rather than the point itself. */
  readonly arrow: Held | null;
}

export interface Click {
  /** Adds to the selection. */
  readonly also: boolean;
  /** By a finger. */
  readonly coarse: boolean;
}

/** The keys held during a drag. */
export interface DragKeys {
  /** Ctrl. */
  readonly snap: boolean;
  /** Alt: free of the usual line. */
  readonly free: boolean;
  /** Shift: through the limit on folds. */
  readonly through: boolean;
}

export interface PointerEvents {
  readonly find: (x: number, y: number, coarse: boolean) => Hold | null;
  /** Whether every drag is to draw a box. */
  readonly boxing: () => boolean;
  readonly hover: (hold: Hold | null) => void;
  readonly click: (x: number, y: number, hold: Hold | null, how: Click) => void;
  /** A double click; `ring` with Alt. */
  readonly double: (x: number, y: number, how: { also: boolean; ring: boolean }) => void;
  readonly grab: (hold: Hold, press: Ray) => DragSession | null;
  /** A drag from here turns the camera. */
  readonly turn: (x: number, y: number) => void;
  /** The wheel is about to bring the camera nearer to what is here. */
  readonly zoom: (x: number, y: number) => void;
  readonly drag: (session: DragSession, how: DragKeys, ray?: Ray) => void;
  readonly box: (box: Box | null) => void;
  /** `also` adds what it holds to the selection. */
  readonly choose: (box: Box, also: boolean) => void;
}

interface Press extends Place {
  readonly event: PointerEvent;
  readonly kind: "turn" | "drag" | "box";
  readonly hold: Hold | null;
  session: DragSession | null;
  moved: boolean;
}

const coarse = (event: PointerEvent): boolean => event.pointerType === "touch";

export class PointerTool {
  readonly #canvas: HTMLCanvasElement;
  readonly #stage: Stage;
  readonly #events: PointerEvents;
  readonly #off = new AbortController();
  #press: Press | null = null;
  /** The keys held at the last move of a drag. */
  #how: DragKeys = { snap: false, free: false, through: false };
  /** A press that is being given to the camera controls. */
  #handedOver: Event | null = null;

  constructor(canvas: HTMLCanvasElement, stage: Stage, events: PointerEvents) {
    this.#canvas = canvas;
    this.#stage = stage;
    this.#events = events;
    const { signal } = this.#off;
    // Before the camera controls see it: a press on a point must not turn the view.
    canvas.addEventListener("pointerdown", (e) => this.#down(e), { capture: true, signal });
    const onWheel = (event: WheelEvent): void => {
      const { x, y } = this.#place(event);
      this.#events.zoom(x, y);
    };
    canvas.addEventListener("wheel", onWheel, { capture: true, passive: true, signal });
    const onDouble = (event: MouseEvent): void => {
      const { x, y } = this.#place(event);
      this.#events.double(x, y, { also: addsTo(event), ring: event.altKey });
    };
    canvas.addEventListener("dblclick", onDouble, { signal });
    canvas.addEventListener("pointermove", (e) => this.#move(e), { signal });
    canvas.addEventListener("pointerup", (e) => this.#up(e), { signal });
    canvas.addEventListener("pointercancel", () => this.abandon(), { signal });
    canvas.addEventListener("pointerleave", () => this.#events.hover(null), { signal });
  }

  get dragging(): boolean {
    return this.#press?.session !== null && this.#press?.session !== undefined;
  }

  /** Gives up what the pointer was doing; a design that was dragged goes back to where it was. */
  abandon(): void {
    const session = this.#press?.session;
    this.#finish();
    session?.abandon();
  }

  /** The lock changed while the pointer rests. */
  refresh(): void {
    if (this.#press?.session) this.#events.drag(this.#press.session, this.#how);
  }

  dispose(): void {
    this.#off.abort();
  }

  #finish(): void {
    if (this.#press?.kind === "box") this.#events.box(null);
    this.#press = null;
    this.#stage.orbit.enabled = true;
  }

  #down(event: PointerEvent): void {
    if (event === this.#handedOver) return;
    if (!event.isPrimary) {
      this.#secondFinger();
      return;
    }
    if (event.button !== 0) return;
    const { x, y } = this.#place(event);
    const hold = this.#events.find(x, y, coarse(event));
    const kind =
      event.shiftKey || this.#events.boxing() ? "box" : hold && !readOnly.value ? "drag" : "turn";
    this.#press = { event, x, y, kind, hold, session: null, moved: false };
    if (kind === "turn") {
      this.#events.turn(x, y);
      return;
    }
    this.#stage.orbit.enabled = false;
    this.#canvas.setPointerCapture(event.pointerId);
  }

  /** Two fingers are for the camera, unless the first is moving a point already. */
  #secondFinger(): void {
    const press = this.#press;
    if (!press || press.kind === "turn" || press.session) return;
    this.#finish();
    this.#handedOver = new PointerEvent("pointerdown", press.event);
    this.#canvas.dispatchEvent(this.#handedOver);
  }

  #move(event: PointerEvent): void {
    const { x, y } = this.#place(event);
    const press = this.#press;
    if (!press) {
      if (event.pointerType === "mouse" && event.buttons === 0) {
        this.#events.hover(this.#events.find(x, y, false));
      }
      return;
    }
    if (!event.isPrimary) return;
    const slack = coarse(event) ? SLACK.coarse : SLACK.fine;
    press.moved ||= Math.hypot(x - press.x, y - press.y) > slack;
    if (!press.moved) return;
    if (press.kind === "box") this.#events.box(boxOf(press, x, y));
    if (press.kind === "drag" && press.hold) this.#drag(press, press.hold, event);
  }

  #drag(press: Press, hold: Hold, event: PointerEvent): void {
    press.session ??= this.#events.grab(hold, this.#rayAt(press.x, press.y));
    if (!press.session) {
      this.#finish();
      return;
    }
    const { x, y } = this.#place(event);
    const { altKey: free, shiftKey: through } = event;
    this.#how = { snap: event.ctrlKey || event.metaKey, free, through };
    this.#events.drag(press.session, this.#how, this.#rayAt(x, y));
  }

  #up(event: PointerEvent): void {
    const press = this.#press;
    if (!press || event.button !== 0 || !event.isPrimary) return;
    this.#finish();
    const { x, y } = this.#place(event);
    const also = addsTo(event) || press.kind === "box";
    if (!press.moved)
      this.#events.click(press.x, press.y, press.hold, { also, coarse: coarse(event) });
    else if (press.kind === "box") this.#events.choose(boxOf(press, x, y), press.event.shiftKey);
    else press.session?.end();
  }

  #place(event: MouseEvent): Place {
    const { left, top } = this.#canvas.getBoundingClientRect();
    return { x: event.clientX - left, y: event.clientY - top };
  }

  #rayAt(x: number, y: number): Ray {
    const { width, height } = this.#canvas.getBoundingClientRect();
    return this.#stage.rayThrough((2 * x) / width - 1, 1 - (2 * y) / height);
  }
}

const addsTo = ({ ctrlKey, metaKey, shiftKey }: MouseEvent): boolean =>
  ctrlKey || metaKey || shiftKey;

const boxOf = (press: Press, x: number, y: number): Box => ({
  left: Math.min(press.x, x),
  top: Math.min(press.y, y),
  right: Math.max(press.x, x),
  bottom: Math.max(press.y, y),
});
