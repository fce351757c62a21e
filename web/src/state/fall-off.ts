// SPDX-License-Identifier: MIT
// How the points of a group take part in a move of it.

import { fallOffWeights, middleOf } from "../mesh/fall-off.ts";
import { basePoint } from "./editing.ts";
import type { Page } from "./page.ts";

/** The share that each of `vertices` moves by. It falls off from `leader`, or without one from their
 * middle, as they lie in the mesh that was opened: the same move again goes on the same way. */
export function moveWeights(
  page: Page,
  vertices: readonly number[],
  leader: number | null,
): readonly number[] {
  const share = page.fallOff.value;
  if (share === 0) return vertices.map(() => 1);
  const places = vertices.map((vertex) => basePoint(page, vertex));
  const middle = leader === null ? middleOf(places) : basePoint(page, leader);
  return fallOffWeights(places, middle, share, page.mesh.value?.report.meanEdge ?? 1);
}
