// SPDX-License-Identifier: MIT
// What a view has to hold, and what lies over it.

import type { Page } from "../state/page.ts";
import type { Subject } from "./clearance.ts";
import type { Box } from "./picking.ts";
import type { Shell } from "./shell.ts";

/** Height of the legend over its width once there is something to count: it grows with an edit. */
const GROWN = 0.65;

export const wholeOf = ({ current, topology }: Shell): Subject => ({
  points: current,
  edges: topology.edges,
});

export interface LowerCorners {
  /** What lies over the lower corners of the view; a fitted model is not under it. */
  readonly legend: HTMLElement;
  readonly views: HTMLElement;
}

/** Where the legend and the buttons of the views lie, or will once there is an edit. */
export function boxesOver(page: Page, canvas: HTMLElement, { legend, views }: LowerCorners): Box[] {
  const { left, top } = canvas.getBoundingClientRect();
  return [legend, views].map((part, k) => {
    const box = part.getBoundingClientRect();
    const grows = k === 0 && page.colourBy.peek() !== "none";
    const high = Math.max(box.height, grows ? GROWN * box.width : 0);
    const [right, bottom] = [box.right - left, box.bottom - top];
    return { left: box.left - left, right, top: bottom - high, bottom };
  });
}
