// SPDX-License-Identifier: MIT
import type { Vector } from "./vector.ts";

/** The lowest and the highest x, y and z. */
export interface Extent {
  readonly low: Vector;
  readonly high: Vector;
}

/** @param points three numbers each */
export function extentOf(points: ArrayLike<number>): Extent {
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (let k = 0; k < points.length; ++k) {
    const axis = (k % 3) as 0 | 1 | 2;
    low[axis] = Math.min(low[axis], points[k] ?? 0);
    high[axis] = Math.max(high[axis], points[k] ?? 0);
  }
  return { low, high };
}
