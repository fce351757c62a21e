// SPDX-License-Identifier: MIT
// A line from where each handle was to where it is pulled, over the canvas as the handles are.
import type { Point } from "../design/design.ts";
import { ElementPool } from "./element-pool.ts";
import { MANY } from "./markers.ts";
import { project, type View } from "./picking.ts";

export interface Pull {
  readonly vertex: number;
  /** Display coordinates. */
  readonly to: Point;
  /** The handle stopped on the way there. */
  readonly open: boolean;
}

/** More lines than this would hide the model. */
const LIMIT = 100;
/** Pixels: a shorter one would only smear its handle. */
const SHORTEST = 14;

export class PullLines {
  readonly #lines: ElementPool;
  #pulls: readonly Pull[] = [];

  constructor(layer: HTMLElement) {
    this.#lines = new ElementPool(() => {
      const line = document.createElement("span");
      line.className = "pull";
      layer.prepend(line);
      return line;
    });
  }

  set(pulls: readonly Pull[]): void {
    this.#pulls = pulls.slice(0, LIMIT);
    this.#lines.resize(this.#pulls.length);
    const thin = this.#pulls.length > MANY;
    for (const [k, { open }] of this.#pulls.entries()) {
      this.#lines.at(k)?.classList.toggle("open", open);
      this.#lines.at(k)?.classList.toggle("thin", thin);
    }
  }

  /** `base`: display coordinates of all points before the edit. */
  place(base: Float32Array, view: View): void {
    this.#pulls.forEach(({ vertex, to }, k) => {
      const line = this.#lines.at(k);
      const [from, end] = [project(base, vertex, view), project(Float32Array.from(to), 0, view)];
      if (!line) return;
      const [dx, dy] = from && end ? [end.x - from.x, end.y - from.y] : [0, 0];
      const length = Math.hypot(dx, dy);
      line.hidden = length < SHORTEST;
      if (!from || line.hidden) return;
      line.style.width = `${length.toFixed(1)}px`;
      line.style.transform = `translate(${from.x.toFixed(1)}px, ${from.y.toFixed(1)}px) rotate(${Math.atan2(dy, dx).toFixed(4)}rad)`;
    });
  }
}
