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

/** The keyboard in the 3D view: points by arrows, the camera by Shift and arrows. */
export class ViewKeys {
  readonly #viewport: Viewport;
  readonly #off = new AbortController();

  constructor(canvas: HTMLCanvasElement, viewport: Viewport) {
    this.#viewport = viewport;
    const { signal } = this.#off;
    canvas.addEventListener("keydown", (event) => this.#down(event), { signal });
    const byPointer = (on: boolean) => () => canvas.classList.toggle("by-pointer", on);
    canvas.addEventListener("pointerdown", byPointer(true), { signal });
    canvas.addEventListener("blur", byPointer(false), { signal });
  }

  dispose(): void {
    this.#off.abort();
  }

  #down(event: KeyboardEvent): void {
    const command = event.ctrlKey || event.metaKey;
    const arrow = ARROWS[event.key];
    const key = event.key.toLowerCase();
    const axis = AXES[key];
    const name = VIEWS[key];
    if (arrow && event.shiftKey) this.#viewport.turn(arrow[0], arrow[1]);
    else if (arrow) this.#viewport.stepSelection(arrow[0], arrow[1], command);
    else if (command && key === "a") selectHandles();
    else if (command) return;
    else if (axis) toggleLock(axis, event.shiftKey);
    else if (name) this.#viewport.view(name);
    else if (key === "f") this.#viewport.fit();
    else if (key === "p" && selected.value !== null) togglePins();
    else if (event.key === "+" || event.key === "=") this.#viewport.zoom(0.88);
    else if (event.key === "-") this.#viewport.zoom(1 / 0.88);
    else if (event.key === "Escape") this.#viewport.escape();
    else return;
    event.preventDefault();
  }
}
