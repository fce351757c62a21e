// SPDX-License-Identifier: MIT
// Figures per panel, of the last finished design.
import { effect } from "@preact/signals";
import { client } from "./connection.ts";
import { history, panelFigures, selectedPanel } from "./store.ts";

export interface PanelRow {
  readonly panel: number;
  /** Model units. */
  readonly gap: number;
  readonly mmPerM: number;
}

/** Larger meshes are measured when asked, not after every edit. */
const EAGER = 200_000;

/** Measures the panels again whenever a design is finished. */
export function keepPanelFigures(): () => void {
  return effect(() => {
    const design = history.value?.present;
    if (!design) return;
    client.ask({ kind: "panels" }).then(
      (answer) => {
        if (answer.kind !== "panels" || answer.figures.length > 2 * EAGER) return;
        panelFigures.value = answer.figures;
        if ((selectedPanel.peek() ?? 0) * 2 >= answer.figures.length) selectedPanel.value = null;
      },
      () => {
        panelFigures.value = null;
      },
    );
  });
}

/** The panels furthest from flat, worst first. */
export function worstPanels(figures: Float32Array, count: number): PanelRow[] {
  const worst: PanelRow[] = [];
  for (let panel = 0; 2 * panel + 1 < figures.length; ++panel) {
    const mmPerM = figures[2 * panel + 1] ?? 0;
    if (worst.length === count && mmPerM <= (worst.at(-1)?.mmPerM ?? 0)) continue;
    const place = worst.findIndex((row) => row.mmPerM < mmPerM);
    const row = { panel, gap: figures[2 * panel] ?? 0, mmPerM };
    worst.splice(place < 0 ? worst.length : place, 0, row);
    worst.length = Math.min(worst.length, count);
  }
  return worst;
}
