// SPDX-License-Identifier: MIT
// How far the points of the design shown are from where they were asked to go.
import { computed } from "@preact/signals";
import { type Design, type HandleRow, leftBehind } from "./design.ts";
import { shownPoint } from "./editing.ts";
import { draft, history, unit } from "./store.ts";
import { convert } from "./units.ts";

/** Millimetres: less is not worth a word. */
const SMALLEST = 0.1;

export interface Shortfall {
  readonly vertex: number;
  /** Model units. */
  readonly length: number;
}

const lengthOf = ({ vertex, target }: HandleRow, design: Design): number => {
  const at = shownPoint(vertex, design.shape);
  return Math.hypot(...target.map((x, axis) => x - (at[axis] ?? 0)));
};

/** Of the last finished design; pinned points have no target. */
export const shortfalls = computed((): readonly Shortfall[] => {
  const design = history.value?.present;
  if (!design) return [];
  const asked = design.handles.filter(({ pinned }) => !pinned);
  const all = asked.map((row) => ({ vertex: row.vertex, length: lengthOf(row, design) }));
  return all.filter(({ length }) => convert(length, unit.value, "mm") > SMALLEST);
});

/** A variation takes points away from their targets; an edit stops short of them. */
export const varied = computed(() => {
  const design = history.value?.present;
  return design ? leftBehind(design) : false;
});

/** False while something moves: then the lengths are those of before. */
export const settled = computed(() => draft.value === history.value?.present);
