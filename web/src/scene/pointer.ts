// SPDX-License-Identifier: MIT
// Presses become clicks, drags of points, areas or turns of the camera; with mouse, pen and touch.

import type { Ray } from "three";
import type { Outcome } from "../state/action-queue.ts";
import type { Page } from "../state/page.ts";
import type { AreaTool } from "../state/page-state.ts";
import { typePull } from "../state/typed-pull.ts";
import type { Arrow } from "./constraint.ts";
import type { DragSession } from "./drag-session.ts";
import { boxAround, extended, type Outline } from "./outline.ts";
import type { Place } from "./picking.ts";
import type { Stage } from "./stage.ts";

/** Pixels a press may wander and still be a click; fingers are less steady. */
const SLACK = { fine: 3, coarse: 8 };

/** What lies under a pixel that can be taken hold of. */
export interface Hold {
  readonly vertex: number;
  /** Set when an arrow or plane of the gizmo was hit rather than the point itself. */
  readonly arrow: Arrow | null;
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
  /** By a finger, beside which no key is held. */
  readonly coarse: boolean;
}

export interface PointerEvents {
  readonly find: (x: number, y: number, coarse: boolean) => Hold | null;
  /** What every drag is to draw around points; null: drags do what they usually do. */
  readonly area: () => AreaTool | null;
  /** `at`: null where it has left the view. */
  readonly hover: (hold: Hold | null, at: Place | null) => void;
  readonly click: (x: number, y: number, hold: Hold | null, how: Click) => void;
  /** A double click; `ring` with Alt. */
  readonly double: (x: number, y: number, how: { also: boolean; ring: boolean }) => void;
  readonly grab: (hold: Hold, press: Ray) => DragSession | null;
  /** A drag from here turns the camera. */
  readonly turn: (x: number, y: number) => void;
  /** The wheel is about to bring the camera nearer to what is here. */
  readonly zoom: (x: number, y: number) => void;
  readonly drag: (session: DragSession, how: DragKeys, ray?: Ray) => void;
  /** A finger drags points and is here; null: no finger does. */
  readonly finger: (at: Place | null) => void;
  /** A finger let go of points that it dragged, whose drag ends so. */
  readonly lifted: (hold: Hold, ended: Outcome) => void;
  /** Of the area that is being drawn; null once it is done. */
  readonly outline: (outline: Outline | null) => void;
  /** `also` adds what it holds to the selection. */
  readonly choose: (outline: Outline, also: boolean) => void;
}

interface Press extends Place {
  readonly event: PointerEvent;
  readonly kind: "turn" | "drag" | AreaTool;
  readonly hold: Hold | null;
  /** Of the area drawn so far. */
  outline: Outline;
  session: DragSession | null;
  moved: boolean;
}

const coarse = (event: PointerEvent): boolean => event.pointerType === "touch";

export class PointerTool {
  readonly #page: Page;
  readonly #canvas: HTMLCanvasElement;
  readonly #stage: Stage;
  readonly #events: PointerEvents;
  readonly #off = new AbortController();
  #press: Press | null = null;
  /** The keys held at the last move of a drag. */
  #how: DragKeys = { snap: false, free: false, through: false, coarse: false };
  /** A press that is being given to the camera controls. */
  #handedOver: Event | null = null;

  constructor(page: Page, canvas: HTMLCanvasElement, stage: Stage, events: PointerEvents) {
    this.#page = page;
    this.#canvas = canvas;
    this.#stage = stage;
    this.#events = events;
    const { signal } = this.#off;
    // Heard before the camera controls hear it: a press on a point must not turn the view.
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
    // Heard before the shortcuts, which have digits for views.
    window.addEventListener("keydown", (e) => this.#type(e), { capture: true, signal });
    // A finger that is lifted leaves what it showed.
    const onLeave = (event: PointerEvent): void => {
      if (!coarse(event)) this.#events.hover(null, null);
    };
    canvas.addEventListener("pointerleave", onLeave, { signal });
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

  /** Digits during a drag are its length, Enter ends it there. */
  #type(event: KeyboardEvent): void {
    const session = this.#press?.session;
    if (!session || event.ctrlKey || event.metaKey) return;
    const done = event.key === "Enter" && this.#page.pull.value?.typed;
    if (!done && !typePull(this.#page, figureOf(event))) return;
    event.preventDefault();
    if (!done) {
      this.refresh();
      return;
    }
    this.#finish();
    void session.end();
  }

  #finish(): void {
    if (this.#press && isArea(this.#press.kind)) this.#events.outline(null);
    this.#press = null;
    this.#events.finger(null);
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
    const kind = this.#kindOf(event, hold);
    this.#press = { event, x, y, kind, hold, outline: [{ x, y }], session: null, moved: false };
    if (kind === "turn") {
      this.#events.turn(x, y);
      return;
    }
    this.#stage.orbit.enabled = false;
    this.#canvas.setPointerCapture(event.pointerId);
  }

  #kindOf(event: PointerEvent, hold: Hold | null): Press["kind"] {
    const tool = this.#events.area();
    if (tool) return tool;
    if (event.shiftKey) return event.altKey ? "lasso" : "box";
    return hold && !this.#page.readOnly.value ? "drag" : "turn";
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
        this.#events.hover(this.#events.find(x, y, false), { x, y });
      }
      return;
    }
    if (!event.isPrimary) return;
    const slack = coarse(event) ? SLACK.coarse : SLACK.fine;
    press.moved ||= Math.hypot(x - press.x, y - press.y) > slack;
    if (!press.moved) return;
    if (isArea(press.kind)) {
      // The point that it began at is no longer looked at.
      this.#events.hover(null, null);
      press.outline =
        press.kind === "box" ? boxAround(press, { x, y }) : extended(press.outline, { x, y });
      this.#events.outline(press.outline);
    }
    if (press.kind === "drag" && press.hold) this.#drag(press, press.hold, event);
  }

  #drag(press: Press, hold: Hold, event: PointerEvent): void {
    press.session ??= this.#events.grab(hold, this.#rayAt(press.x, press.y));
    if (!press.session) {
      this.#finish();
      return;
    }
    const { x, y } = this.#place(event);
    if (coarse(event)) this.#events.finger({ x, y });
    const { altKey: free, shiftKey: through } = event;
    this.#how = { snap: event.ctrlKey || event.metaKey, free, through, coarse: coarse(event) };
    this.#events.drag(press.session, this.#how, this.#rayAt(x, y));
  }

  #up(event: PointerEvent): void {
    const press = this.#press;
    if (!press || event.button !== 0 || !event.isPrimary) return;
    this.#finish();
    const area = isArea(press.kind);
    const also = addsTo(event) || area;
    if (!press.moved)
      this.#events.click(press.x, press.y, press.hold, { also, coarse: coarse(event) });
    else if (area) this.#events.choose(press.outline, press.event.shiftKey);
    else if (press.session && press.hold) {
      const ended = press.session.end();
      if (coarse(event)) this.#events.lifted(press.hold, ended);
    }
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

const MARKS: Readonly<Record<string, string>> = {
  Period: ".",
  NumpadDecimal: ".",
  Minus: "-",
  NumpadSubtract: "-",
};

/** The key, also where Alt, which a free drag holds, makes another character of it. */
function figureOf({ altKey, code, key }: KeyboardEvent): string {
  const digit = /^(?:Digit|Numpad)([0-9])$/.exec(code)?.[1];
  return altKey ? (digit ?? MARKS[code] ?? key) : key;
}

const addsTo = ({ ctrlKey, metaKey, shiftKey }: MouseEvent): boolean =>
  ctrlKey || metaKey || shiftKey;

const isArea = (kind: Press["kind"]): kind is AreaTool => kind === "box" || kind === "lasso";
