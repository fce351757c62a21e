// SPDX-License-Identifier: MIT
// What is said of a planarising that is tried out.

import type { Trial } from "../../design/planarising.ts";
import type { Shape } from "../../solver/protocol.ts";
import { damageWords } from "../../state/damage.ts";

/** Where two meshes of one topology differ. */
export function shapeOf(now: Float64Array, base: Float64Array): Shape {
  const moved: number[] = [];
  for (let v = 0; 3 * v < now.length; ++v)
    if ([0, 1, 2].some((c) => now[3 * v + c] !== base[3 * v + c])) moved.push(v);
  const positions = Float64Array.from(moved.flatMap((v) => [...now.subarray(3 * v, 3 * v + 3)]));
  return { moved: Int32Array.from(moved), positions };
}

/** The angle that 95 % of the panels fold by at most; null without one. */
export function usualFold(folds: Float32Array): number | null {
  const sorted = folds.filter((fold) => fold >= 0).sort();
  return sorted[Math.ceil(0.95 * sorted.length) - 1] ?? null;
}

/** "4 panels became concave"; "none" where no panel is spoilt. */
export const spoiltWords = ({ measures }: Trial): string =>
  measures ? damageWords(measures.damage, measures.health) || "none" : "not measured";
