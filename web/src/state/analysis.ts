// SPDX-License-Identifier: MIT
// Figures per panel, of the last finished design.
import { batch, effect } from "@preact/signals";
import { client } from "./connection.ts";
import { toTargets } from "./design.ts";
import { panelCount } from "./panel-rows.ts";
import { troublesOf } from "./panel-trouble.ts";
import { stopsShort } from "./stopping-short.ts";
import {
  bending,
  colourBy,
  freedom,
  history,
  kindDefects,
  measurable,
  mesh,
  nodeCounts,
  panelDamage,
  panelFigures,
  panelFolds,
  panelHealth,
  panelTroubles,
  ready,
  selectedPanel,
  shownKind,
  watchFreedom,
} from "./store.ts";

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
    const defectsOf = shownKind.value;
    client.ask({ kind: "panels", also: { fairness, folds: true, defectsOf } }).then(
      (answer) => {
        const measures = answer.kind === "panels" ? answer.measures : null;
        if (!measures || panelCount(measures.figures) > EAGER) return;
        batch(() => {
          panelFigures.value = measures.figures;
          panelHealth.value = measures.health;
          nodeCounts.value = measures.nodes;
          panelTroubles.value = troublesOf(measures.health, measures.damage);
          if (history.peek()?.present === design) panelDamage.value = measures.damage;
          bending.value = measures.bending;
          panelFolds.value = measures.folds;
          const values = measures.defects;
          kindDefects.value = defectsOf && values && { kind: defectsOf, values };
        });
        if ((selectedPanel.peek() ?? 0) >= panelCount(measures.figures)) selectedPanel.value = null;
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
    const opened = mesh.peek();
    const short = opened !== null && stopsShort(design, opened.positions, opened.report.meanEdge);
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
