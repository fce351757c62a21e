// SPDX-License-Identifier: MIT
import type { Viewport } from "../scene/viewport.ts";

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** The keyboard in the 3D view: points by arrows, the camera by Shift and arrows. */
export class ViewKeys {
  readonly #viewport: Viewport;
  readonly #off = new AbortController();

  constructor(canvas: HTMLCanvasElement, viewport: Viewport) {
    this.#viewport = viewport;
    canvas.addEventListener("keydown", (event) => this.#down(event), { signal: this.#off.signal });
  }

  dispose(): void {
    this.#off.abort();
  }

  #down(event: KeyboardEvent): void {
    const arrow = ARROWS[event.key];
    if (arrow && event.shiftKey) this.#viewport.turn(arrow[0], arrow[1]);
    else if (arrow) this.#viewport.stepSelection(arrow[0], arrow[1]);
    else if (event.key === "+" || event.key === "=") this.#viewport.zoom(0.88);
    else if (event.key === "-") this.#viewport.zoom(1 / 0.88);
    else if (event.key === "Escape") this.#viewport.escape();
    else return;
    event.preventDefault();
  }
}
