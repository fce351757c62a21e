// SPDX-License-Identifier: MIT
// Figures per panel, of the last finished design.
import { batch, effect } from "@preact/signals";
import { client } from "./connection.ts";
import { toTargets } from "./design.ts";
import { stopsShort } from "./stopping-short.ts";
import {
  bending,
  colourBy,
  freedom,
  history,
  measurable,
  mesh,
  panelDamage,
  panelFigures,
  panelHealth,
  ready,
  selectedPanel,
  watchFreedom,
} from "./store.ts";

export const OUTLINES = ["convex", "concave", "crosses itself"] as const;

export interface PanelRow {
  readonly panel: number;
  /** Model units. */
  readonly gap: number;
  readonly mmPerM: number;
  /** Place in OUTLINES. */
  readonly outline: number;
  /** Model units. */
  readonly edge: number;
  /** Degrees. */
  readonly angle: number;
}

export type PanelColumn = keyof PanelRow;

/** Panels: larger meshes have no table. */
const EAGER = 200_000;

/** Measures the panels again whenever a design is finished. */
export function keepPanelFigures(): () => void {
  return effect(() => {
    const design = history.value?.present;
    measurable.value;
    if (!design || !ready.value) return;
    panelDamage.value = null;
    const fairness = colourBy.value === "fairness" ? design.settings.fairness : null;
    client.ask({ kind: "panels", fairness }).then(
      (answer) => {
        const measures = answer.kind === "panels" ? answer.measures : null;
        if (!measures || measures.figures.length > 2 * EAGER) return;
        batch(() => {
          panelFigures.value = measures.figures;
          panelHealth.value = measures.health;
          if (history.peek()?.present === design) panelDamage.value = measures.damage;
          bending.value = measures.bending;
        });
        if ((selectedPanel.peek() ?? 0) * 2 >= measures.figures.length) selectedPanel.value = null;
      },
      () => {
        panelFigures.value = null;
      },
    );
  });
}

/** Counts what a finished edit leaves free, where a point stops short or someone looks. */
export function keepFreedom(): () => void {
  return effect(() => {
    const design = history.value?.present;
    measurable.value;
    if (!design || !ready.value) return;
    const base = mesh.peek()?.positions;
    const short = base !== undefined && stopsShort(design, base);
    if (!short && !watchFreedom.value) {
      freedom.value = null;
      return;
    }
    client.ask({ kind: "freedom", targets: toTargets(design.handles) }).then(
      (answer) => {
        if (answer.kind === "freedom" && history.peek()?.present === design)
          freedom.value = answer.freedom;
      },
      () => {
        freedom.value = null;
      },
    );
  });
}

function rowOf(panel: number, figures: Float32Array, health: Float32Array): PanelRow {
  return {
    panel,
    gap: figures[2 * panel] ?? 0,
    mmPerM: figures[2 * panel + 1] ?? 0,
    outline: health[4 * panel] ?? 0,
    edge: health[4 * panel + 1] ?? 0,
    angle: health[4 * panel + 2] ?? 0,
  };
}

/** The first `count` panels by `column`; panels that are equal stay in their order. */
export function firstPanels(
  figures: Float32Array,
  health: Float32Array,
  column: PanelColumn,
  descending: boolean,
  count: number,
): PanelRow[] {
  const first: PanelRow[] = [];
  const before = (a: PanelRow, b: PanelRow): boolean =>
    descending ? a[column] > b[column] : a[column] < b[column];
  for (let panel = 0; 2 * panel + 1 < figures.length; ++panel) {
    const row = rowOf(panel, figures, health);
    const last = first.at(-1);
    if (first.length === count && last && !before(row, last)) continue;
    const place = first.findIndex((other) => before(row, other));
    first.splice(place < 0 ? first.length : place, 0, row);
    first.length = Math.min(first.length, count);
  }
  return first;
}

export interface HealthCounts {
  readonly convex: number;
  readonly changed: number;
  readonly concave: number;
  readonly crossing: number;
}

export function countHealth(health: Float32Array): HealthCounts {
  let [convex, changed, concave, crossing] = [0, 0, 0, 0];
  for (let k = 0; k + 3 < health.length; k += 4) {
    if (health[k] === 0) convex += 1;
    if (health[k] === 1) concave += 1;
    if (health[k] === 2) crossing += 1;
    if (health[k + 3] === 1) changed += 1;
  }
  return { convex, changed, concave, crossing };
}
