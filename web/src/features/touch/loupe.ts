// SPDX-License-Identifier: MIT
// What a finger covers while it drags a point, larger and beside it. Fetched with the first such drag.
import "./loupe.css";
import type { Place } from "../../scene/picking.ts";

/** Pixels across. */
const SIZE = 112;
const ZOOM = 2;
/** Pixels between the middle of the loupe and the finger. */
const AWAY = 100;
/** Pixels at the top of the view that the tools cover. */
const TOOLS = 52;
/** Pixels: the radius of a point's mark, and of its rim. */
const [MARK, RIM] = [7, 9];

/** The middle of the loupe: above the finger, and near the top of the view at the side with more room. */
export function besideFinger({ x, y }: Place, width: number): Place {
  const half = SIZE / 2;
  const within = Math.min(Math.max(x, half), Math.max(half, width - half));
  if (y - AWAY - half >= TOOLS) return { x: within, y: y - AWAY };
  return { x: x < width / 2 ? x + AWAY : x - AWAY, y: Math.max(y, TOOLS + half) };
}

/** The mark nearest to the finger, however far that has gone on: a drag is held back, or to a line. */
export function followed(finger: Place, marks: readonly Place[]): Place | null {
  let [found, nearest]: [Place | null, number] = [null, Number.POSITIVE_INFINITY];
  for (const mark of marks) {
    const gap = Math.hypot(mark.x - finger.x, mark.y - finger.y);
    if (gap < nearest) [found, nearest] = [mark, gap];
  }
  return found;
}

export class Loupe {
  readonly #view: HTMLCanvasElement;
  readonly #glass = document.createElement("canvas");

  /** @param view the 3D view, which it lies over */
  constructor(view: HTMLCanvasElement) {
    this.#view = view;
    this.#glass.className = "loupe";
    this.#glass.hidden = true;
    this.#glass.setAttribute("aria-hidden", "true");
    view.after(this.#glass);
  }

  hide(): void {
    this.#glass.hidden = true;
  }

  /**
   * Right after the view was drawn: later its picture is gone. `marks`: where selected points are; the
   * one that follows the finger is in the middle.
   */
  draw(finger: Place, marks: readonly Place[]): void {
    const { width, height } = this.#view.getBoundingClientRect();
    const ratio = Math.min(window.devicePixelRatio, 2);
    this.#glass.hidden = false;
    this.#glass.width = SIZE * ratio;
    this.#glass.height = SIZE * ratio;
    const { x, y } = besideFinger(finger, width);
    this.#glass.style.transform = `translate(${(x - SIZE / 2).toFixed(0)}px, ${(y - SIZE / 2).toFixed(0)}px)`;
    const context = this.#glass.getContext("2d");
    if (!context) return;
    context.scale(ratio * ZOOM, ratio * ZOOM);
    const middle = followed(finger, marks) ?? finger;
    context.translate(SIZE / (2 * ZOOM) - middle.x, SIZE / (2 * ZOOM) - middle.y);
    context.drawImage(this.#view, 0, 0, width, height);
    this.#mark(context, marks);
  }

  /** The points' marks lie over the view, not in its picture. */
  #mark(context: CanvasRenderingContext2D, marks: readonly Place[]): void {
    const { color, backgroundColor } = getComputedStyle(this.#glass);
    for (const { x, y } of marks) {
      for (const [radius, colour] of [
        [RIM, backgroundColor],
        [MARK, color],
      ] as const) {
        context.beginPath();
        context.arc(x, y, radius / ZOOM, 0, 2 * Math.PI);
        context.fillStyle = colour;
        context.fill();
      }
    }
  }

  dispose(): void {
    this.#glass.remove();
  }
}
