// SPDX-License-Identifier: MIT
// The measured panels as rows of a table, in any order, and as classes.

import { PER_PANEL } from "../solver/protocol.ts";

/** Of every panel, one after the other. */
export interface MeasuredPanels {
  readonly figures: Float32Array;
  readonly health: Float32Array;
  /** Places in TROUBLES. */
  readonly troubles: Float32Array;
  /** See urgencyOf(). */
  readonly urgency: Float32Array;
  /** The sharpest fold with a neighbour, degrees; null where nobody measured it. */
  readonly folds: Float32Array | null;
  /** Degrees by which panels miss a kind of constraint, -1 if free of it; null while nobody looks. */
  readonly defects: Float32Array | null;
}

export interface PanelRow {
  readonly panel: number;
  /** Model units. */
  readonly gap: number;
  readonly mmPerM: number;
  /** mmPerM, or 0 where rounding accounts for it. */
  readonly excess: number;
  /** 0 convex, 1 concave, 2 crosses itself. */
  readonly outline: number;
  /** Place in TROUBLES. */
  readonly trouble: number;
  /** Larger is to be looked at first. */
  readonly urgency: number;
  /** Degrees. */
  readonly fold: number;
  /** The shortest, model units. */
  readonly edge: number;
  /** The smallest inside the panel, degrees. */
  readonly angle: number;
  /** The core's PanelChange: 0 unchanged, 1 to be cut again, 2 only a new bevel. */
  readonly changed: number;
  /** Degrees; -1: it misses nothing. */
  readonly defect: number;
}

export type PanelColumn = keyof PanelRow;

/** Where a column's value is: the array, and the place among a panel's numbers. */
const PLACES: Readonly<Record<PanelColumn, readonly [keyof MeasuredPanels, number]>> = {
  panel: ["figures", 0],
  gap: ["figures", 0],
  mmPerM: ["figures", 1],
  excess: ["figures", 2],
  outline: ["health", 0],
  trouble: ["troubles", 0],
  urgency: ["urgency", 0],
  fold: ["folds", 0],
  edge: ["health", 1],
  angle: ["health", 2],
  changed: ["health", 3],
  defect: ["defects", 0],
};

const { figures: FIGURES, health: HEALTH } = PER_PANEL;
const STRIDES = { ...PER_PANEL, troubles: 1, urgency: 1, folds: 1, defects: 1 } as const;

export const panelCount = (figures: Float32Array): number => figures.length / FIGURES;

export function rowOf(panel: number, panels: MeasuredPanels): PanelRow {
  const { figures, health, defects } = panels;
  const [gap = 0, mmPerM = 0, excess = 0] = figures.subarray(FIGURES * panel);
  const [outline = 0, edge = 0, angle = 0, changed = 0] = health.subarray(HEALTH * panel);
  const defect = defects?.[panel] ?? -1;
  const [trouble = 0, urgency = 0] = [panels.troubles[panel], panels.urgency[panel]];
  const fold = panels.folds?.[panel] ?? 0;
  const shape = { outline, trouble, urgency, fold, edge, angle };
  return { panel, gap, mmPerM, excess, ...shape, changed, defect };
}

export interface PanelOrder {
  readonly key: PanelColumn;
  readonly descending: boolean;
  /** Leaves out panels that need not be made again. */
  readonly changedOnly: boolean;
}

/** The first `count` panels in this order; panels that are equal stay in theirs. */
export function firstPanels(
  panels: MeasuredPanels,
  { key, descending, changedOnly }: PanelOrder,
  count: number,
): PanelRow[] {
  const [array, place] = PLACES[key];
  const [values, stride] = [panels[array], STRIDES[array]];
  const value = (panel: number): number =>
    key === "panel" ? panel : (values?.[stride * panel + place] ?? 0);
  const before = (a: number, b: number): boolean =>
    descending ? value(a) > value(b) : value(a) < value(b);
  const first: number[] = [];
  for (let panel = 0; panel < panelCount(panels.figures); ++panel) {
    if (changedOnly && panels.health[HEALTH * panel + 3] === 0) continue;
    const last = first.at(-1);
    if (first.length === count && last !== undefined && !before(panel, last)) continue;
    const at = first.findIndex((other) => before(panel, other));
    first.splice(at < 0 ? first.length : at, 0, panel);
    first.length = Math.min(first.length, count);
  }
  return first.map((panel) => rowOf(panel, panels));
}

/** Panels whose `place`-th number of `stride` is this one, in their order. */
export function panelsWith(value: number, numbers: Float32Array, stride = 1, place = 0): number[] {
  const found: number[] = [];
  for (let k = place; k < numbers.length; k += stride)
    if (numbers[k] === value) found.push((k - place) / stride);
  return found;
}

/** Panels of one of the core's PanelChange. */
export const panelsChanged = (health: Float32Array, change: number): number[] =>
  panelsWith(change, health, HEALTH, PLACES.changed[1]);

export interface HealthCounts {
  readonly convex: number;
  /** Must be made again; `bevel` of them keep their outline. */
  readonly changed: number;
  readonly bevel: number;
  readonly concave: number;
  readonly crossing: number;
}

export function countHealth(health: Float32Array): HealthCounts {
  let [convex, changed, bevel, concave, crossing] = [0, 0, 0, 0, 0];
  for (let k = 0; k + 3 < health.length; k += HEALTH) {
    if (health[k] === 0) convex += 1;
    if (health[k] === 1) concave += 1;
    if (health[k] === 2) crossing += 1;
    if (health[k + 3] !== 0) changed += 1;
    if (health[k + 3] === 2) bevel += 1;
  }
  return { convex, changed, bevel, concave, crossing };
}
