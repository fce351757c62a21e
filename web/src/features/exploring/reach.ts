// SPDX-License-Identifier: MIT
import type { Shape } from "../../solver/protocol.ts";

/** How far the point moves that moves most, model units. */
export function reachOf({ moved, positions }: Shape, base: Float64Array): number {
  let largest = 0;
  moved.forEach((v, k) => {
    const gap = (c: number): number => (positions[3 * k + c] ?? 0) - (base[3 * v + c] ?? 0);
    largest = Math.max(largest, Math.hypot(gap(0), gap(1), gap(2)));
  });
  return largest;
}
