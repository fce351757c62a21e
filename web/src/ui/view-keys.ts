// SPDX-License-Identifier: MIT
import type { ViewName } from "../scene/framing.ts";
import type { Viewport } from "../scene/viewport.ts";
import { toggleLock, togglePins } from "../state/dragging.ts";
import { selectHandles } from "../state/selection.ts";
import { type Lock, selected } from "../state/store.ts";

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

const AXES: Readonly<Record<string, Lock["axis"]>> = { x: "x", y: "y", z: "z", n: "normal" };

const VIEWS: Readonly<Record<string, ViewName>> = {
  1: "Perspective",
  2: "Top",
  3: "Front",
  4: "Side",
};

/** Whether letters typed here are words, or keys are for an open dialog or menu. */
export const takesLetters = (target: EventTarget | null): boolean =>
  (target instanceof HTMLInputElement && target.type !== "range" && target.type !== "checkbox") ||
  target instanceof HTMLSelectElement ||
  document.querySelector(":modal, :popover-open") !== null;

/** Whether arrows move or scroll something here. */
const takesArrows = (target: EventTarget | null): boolean =>
  target instanceof HTMLInputElement || (target instanceof Element && !!target.closest("aside"));

/**
 * The keys of the 3D view, wherever the focus is but in a field: points by arrows, the camera by
 * Shift and arrows.
 */
export class ViewKeys {
  readonly #viewport: Viewport;
  readonly #off = new AbortController();

  constructor(canvas: HTMLCanvasElement, viewport: Viewport) {
    this.#viewport = viewport;
    const { signal } = this.#off;
    window.addEventListener("keydown", (event) => this.#down(event), { signal });
    const byPointer = (on: boolean) => () => canvas.classList.toggle("by-pointer", on);
    canvas.addEventListener("pointerdown", byPointer(true), { signal });
    canvas.addEventListener("blur", byPointer(false), { signal });
  }

  dispose(): void {
    this.#off.abort();
  }

  #down(event: KeyboardEvent): void {
    if (event.defaultPrevented || takesLetters(event.target)) return;
    const command = event.ctrlKey || event.metaKey;
    const arrow = takesArrows(event.target) ? undefined : ARROWS[event.key];
    const key = event.key.toLowerCase();
    const axis = AXES[key];
    const name = VIEWS[key];
    if (arrow && event.shiftKey) this.#viewport.turn(arrow[0], arrow[1]);
    else if (arrow) this.#viewport.stepSelection(arrow[0], arrow[1], command);
    else if (command && key === "a") selectHandles();
    else if (command) return;
    else if (axis) toggleLock(axis, event.shiftKey);
    else if (name) this.#viewport.view(name);
    else if (key === "f") this.#viewport.fit(event.shiftKey);
    else if (key === "p" && selected.value !== null) togglePins();
    else if (event.key === "+" || event.key === "=") this.#viewport.zoom(0.88);
    else if (event.key === "-") this.#viewport.zoom(1 / 0.88);
    else if (event.key === "Escape") this.#viewport.escape();
    else return;
    event.preventDefault();
  }
}
