// SPDX-License-Identifier: MIT
// Whether the structure is in front of a place on screen. The triangles are sorted into squares of the
// screen once, so that hundreds of places cost little more than one.
import { eachOnScreen, type Place, type View } from "./picking.ts";
import type { Triangles } from "./surface-hit.ts";

/** Pixels. */
const SQUARE = 48;

export class Cover {
  readonly #at: Float64Array;
  readonly #triangles: Uint32Array;
  readonly #squares = new Map<number, number[]>();

  constructor({ corners, triangles }: Triangles, view: View) {
    this.#triangles = triangles;
    this.#at = new Float64Array(corners.length).fill(Number.NaN);
    eachOnScreen(corners, view, (c, x, y, depth) => this.#at.set([x, y, depth], 3 * c));
    for (let t = 0; t < triangles.length; t += 3) this.#sort(t, view);
  }

  /** Whether something lies at a pixel in front of a depth, that of eachOnScreen(). */
  hides({ x, y }: Place, depth: number): boolean {
    const here = this.#squares.get(squareOf(Math.floor(x / SQUARE), Math.floor(y / SQUARE)));
    return here?.some((t) => this.#depth(t, x, y) < depth) ?? false;
  }

  #sort(t: number, { width, height }: View): void {
    const range = (axis: 0 | 1, size: number): readonly [number, number] => {
      const all = [0, 1, 2].map((k) => this.#part(t, k, axis));
      return [
        Math.floor(Math.max(0, Math.min(...all)) / SQUARE),
        Math.floor(Math.min(size, Math.max(...all)) / SQUARE),
      ];
    };
    const [[left, right], [top, bottom]] = [range(0, width), range(1, height)];
    // Behind the camera, one of them is no number: no square then.
    for (let column = left; column <= right; ++column) {
      for (let line = top; line <= bottom; ++line) {
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
    const [ax, ay, bx, by, cx, cy] = [0, 1, 2].flatMap((k) => [
      this.#part(t, k, 0) - x,
      this.#part(t, k, 1) - y,
    ]) as [number, number, number, number, number, number];
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
