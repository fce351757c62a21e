// SPDX-License-Identifier: MIT
// How far the points of the design shown are from where they were asked to go.

import { computed } from "@preact/signals";
import { type Design, type HandleRow, leftBehind, type Point } from "../design/design.ts";
import { convert } from "../quantity/units.ts";
import { basePoint, shownPoint } from "./editing.ts";
import { kept, type Page } from "./page.ts";
import { refusedPull } from "./refused-pull.ts";
import { isNoticeable } from "./stopping-short.ts";

/** Millimetres: less is not worth a word. */
const SMALLEST = 0.1;

export interface Shortfall {
  readonly vertex: number;
  /** Model units. */
  readonly length: number;
  /** Whether it is more than of any soft handle. */
  readonly noticeable: boolean;
}

const between = (a: Point, b: Point): number => Math.hypot(...a.map((x, k) => x - (b[k] ?? 0)));

function shortfallOf(
  page: Page,
  { vertex, target }: HandleRow,
  design: Design,
  meanEdge: number,
): Shortfall {
  const length = between(target, shownPoint(page, vertex, design.shape));
  const noticeable = isNoticeable(length, between(target, basePoint(page, vertex)), meanEdge);
  return { vertex, length, noticeable };
}

/**
 * How far a handle of any design of the mesh is from its target at most, model units: from where it was pulled,
 * where a limit refused that. Null without handles, and of a variation, which leaves its targets.
 */
export function largestShortfall(page: Page, design: Design): number | null {
  const pull = refusedPull(page).value;
  const handles = pull?.design === design ? pull.handles : design.handles;
  const all = handles.flatMap(({ vertex, target, pinned }) =>
    pinned ? [] : [between(target, shownPoint(page, vertex, design.shape))],
  );
  return all.length > 0 && !leftBehind(design) ? Math.max(...all) : null;
}

/** The shortfalls of the last finished design; pinned points have no target. */
export const shortfalls = kept((page) =>
  computed((): readonly Shortfall[] => {
    const design = page.history.value?.present;
    if (!design) return [];
    const asked = design.handles.filter(({ pinned }) => !pinned);
    const meanEdge = page.mesh.value?.report.meanEdge ?? 0;
    const all = asked.map((row) => shortfallOf(page, row, design, meanEdge));
    return all.filter(({ length }) => convert(length, page.unit.value, "mm") > SMALLEST);
  }),
);

/** A variation takes points away from their targets; an edit stops short of them. */
export const varied = kept((page) =>
  computed(() => {
    const design = page.history.value?.present;
    return design ? leftBehind(design) : false;
  }),
);

/** False while something moves: then the lengths are those of before. */
export const settled = kept((page) =>
  computed(() => page.draft.value === page.history.value?.present),
);
