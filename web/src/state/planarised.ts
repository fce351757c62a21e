// SPDX-License-Identifier: MIT
import { unit } from "./store.ts";
import { formatLength } from "./units.ts";

/** How far points went when every panel was made flat, in words. @param before x, y, z of each, as `after` */
export function farthest(before: Float64Array, after: Float64Array): string {
  let [most, moved] = [0, 0];
  for (let k = 0; k < after.length; k += 3) {
    const gap = (c: number): number => (after[k + c] ?? 0) - (before[k + c] ?? 0);
    const length = Math.hypot(gap(0), gap(1), gap(2));
    if (length > 0) moved += 1;
    most = Math.max(most, length);
  }
  return `Every panel is flat now: ${moved} points moved, by ${formatLength(most, unit.value)} at most.`;
}
