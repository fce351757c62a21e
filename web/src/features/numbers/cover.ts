// SPDX-License-Identifier: MIT
// Whether the structure is in front of a place on screen. The triangles are sorted into squares of the
// screen once, so that hundreds of places cost little more than one.
import { eachOnScreen, type Place, type View } from "../../scene/picking.ts";
import type { Triangles } from "../../scene/surface-hit.ts";

/** Pixels. */
const SQUARE = 48;

export class Cover {
  readonly #at: Float64Array;
  readonly #triangles: Uint32Array;
  readonly #squares = new Map<number, number[]>();

  /** @param isCut whether a corner is left out of the picture: so is a triangle without another */
  constructor({ corners, triangles }: Triangles, view: View, isCut: (corner: number) => boolean) {
    this.#triangles = triangles;
    this.#at = new Float64Array(corners.length).fill(Number.NaN);
    eachOnScreen(corners, view, (c, x, y, depth) => {
      this.#at[3 * c] = x;
      this.#at[3 * c + 1] = y;
      this.#at[3 * c + 2] = depth;
    });
    for (let t = 0; t < triangles.length; t += 3) {
      const cut = isCut(triangles[t] ?? 0) && isCut(triangles[t + 1] ?? 0);
      if (!cut || !isCut(triangles[t + 2] ?? 0)) this.#sort(t, view);
    }
  }

  /** Whether something lies at a pixel in front of a depth, that of eachOnScreen(). */
  hides({ x, y }: Place, depth: number): boolean {
    const here = this.#squares.get(squareOf(Math.floor(x / SQUARE), Math.floor(y / SQUARE)));
    return here?.some((t) => this.#depth(t, x, y) < depth) ?? false;
  }

  #sort(t: number, { width, height }: View): void {
    const [ax, bx, cx] = [this.#part(t, 0, 0), this.#part(t, 1, 0), this.#part(t, 2, 0)];
    const [ay, by, cy] = [this.#part(t, 0, 1), this.#part(t, 1, 1), this.#part(t, 2, 1)];
    const right = Math.floor(Math.min(width, Math.max(ax, bx, cx)) / SQUARE);
    const bottom = Math.floor(Math.min(height, Math.max(ay, by, cy)) / SQUARE);
    const [left, top] = [Math.min(ax, bx, cx), Math.min(ay, by, cy)];
    // Behind the camera, a coordinate is no number: then no square is covered.
    for (let column = Math.floor(Math.max(0, left) / SQUARE); column <= right; ++column) {
      for (let line = Math.floor(Math.max(0, top) / SQUARE); line <= bottom; ++line) {
        const square = squareOf(column, line);
        const there = this.#squares.get(square);
        if (there) there.push(t);
        else this.#squares.set(square, [t]);
      }
    }
  }

  #part(t: number, k: number, axis: 0 | 1 | 2): number {
    return this.#at[3 * (this.#triangles[t + k] ?? 0) + axis] ?? Number.NaN;
  }

  /** Of the triangle at a pixel; Infinity beside it. */
  #depth(t: number, x: number, y: number): number {
    const [ax, ay] = [this.#part(t, 0, 0) - x, this.#part(t, 0, 1) - y];
    const [bx, by] = [this.#part(t, 1, 0) - x, this.#part(t, 1, 1) - y];
    const [cx, cy] = [this.#part(t, 2, 0) - x, this.#part(t, 2, 1) - y];
    const [a, b, c] = [bx * cy - by * cx, cx * ay - cy * ax, ax * by - ay * bx];
    const sum = a + b + c;
    if (sum === 0 || a * sum < 0 || b * sum < 0 || c * sum < 0) return Number.POSITIVE_INFINITY;
    const [p, q, r] = [this.#part(t, 0, 2), this.#part(t, 1, 2), this.#part(t, 2, 2)];
    return (a * p + b * q + c * r) / sum;
  }
}

/** No screen has so many lines of squares. */
const LINES = 1024;

const squareOf = (column: number, line: number): number => column * LINES + line;
