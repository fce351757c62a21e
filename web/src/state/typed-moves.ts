// SPDX-License-Identifier: MIT
// Moves of the selected points by typed amounts; with a fall-off the amounts are those of their middle.

import { type HandleRow, type Point, withHandle } from "../design/design.ts";
import { add } from "../mesh/vector.ts";
import type { Outcome } from "./action-queue.ts";
import { askedPoint, frameAt } from "./dragging.ts";
import { edit, handleOf } from "./editing.ts";
import { moveWeights } from "./fall-off.ts";
import type { Page } from "./page.ts";

/** `target`: where a point goes, all but pinned ones, with the share of the move that it takes part in. */
function move(
  page: Page,
  vertices: readonly number[],
  target: (vertex: number, weight: number) => Point | null,
): Outcome {
  page.hintVertex.value = null;
  return edit(page, (rows) => {
    const loose = vertices.filter((vertex) => !handleOf(page, vertex)?.pinned);
    const weights = moveWeights(page, loose, null);
    let next: HandleRow[] = [...rows];
    for (const [k, vertex] of loose.entries()) {
      const to = target(vertex, weights[k] ?? 1);
      if (to) next = withHandle(next, { vertex, target: to, pinned: false });
    }
    return next;
  });
}

/** Moves points by the same typed amounts; model units. */
export const moveTogether = (page: Page, vertices: readonly number[], by: Point): Outcome =>
  move(page, vertices, (vertex, weight) => add(askedPoint(page, vertex), by, weight));

/** Moves points by typed amounts along their own surface and out of it. */
export const moveInFrame = (
  page: Page,
  vertices: readonly number[],
  [along, across, out]: Point,
): Outcome =>
  move(page, vertices, (vertex, weight) => {
    const at = frameAt(page, vertex);
    if (!at) return null;
    const forward = add(askedPoint(page, vertex), at.along, weight * along);
    const sideways = add(forward, at.across, weight * across);
    return add(sideways, at.normal, weight * out);
  });
