// SPDX-License-Identifier: MIT
// Figures per panel, of the last finished design.

import { batch, effect } from "@preact/signals";
import { toTargets } from "../design/design.ts";
import { client } from "./connection.ts";
import type { Page } from "./page.ts";
import { panelCount } from "./panel-rows.ts";
import { troublesOf } from "./panel-trouble.ts";
import { stopsShort } from "./stopping-short.ts";

/** Panels: larger meshes have no table. */
const EAGER = 200_000;

/** Measures the panels again whenever a design is finished. */
export function keepPanelFigures(page: Page): () => void {
  return effect(() => {
    const design = page.history.value?.present;
    if (!design || !page.ready.value) return;
    page.panelDamage.value = null;
    const fairness = page.colourBy.value === "fairness" ? design.settings.fairness : null;
    const defectsOf = page.shownKind.value;
    client(page)
      .ask({ kind: "panels", also: { fairness, folds: true, defectsOf } })
      .then(
        (answer) => {
          const measures = answer.kind === "panels" ? answer.measures : null;
          if (!measures || panelCount(measures.figures) > EAGER) return;
          batch(() => {
            page.panelFigures.value = measures.figures;
            page.panelHealth.value = measures.health;
            page.nodeCounts.value = measures.nodes;
            page.panelTroubles.value = troublesOf(measures.health, measures.damage);
            if (page.history.peek()?.present === design) page.panelDamage.value = measures.damage;
            page.bending.value = measures.bending;
            page.panelFolds.value = measures.folds;
            const values = measures.defects;
            page.kindDefects.value = defectsOf && values && { kind: defectsOf, values };
          });
          if ((page.selectedPanel.peek() ?? 0) >= panelCount(measures.figures))
            page.selectedPanel.value = null;
        },
        () => {
          page.panelFigures.value = null;
        },
      );
  });
}

/** Counts what a finished edit leaves free, where a point stops short or someone looks. */
export function keepFreedom(page: Page): () => void {
  return effect(() => {
    const design = page.history.value?.present;
    if (!design || !page.ready.value) return;
    const opened = page.mesh.peek();
    const short = opened !== null && stopsShort(design, opened.positions, opened.report.meanEdge);
    if (!short && !page.watchFreedom.value) {
      page.freedom.value = null;
      return;
    }
    client(page)
      .ask({ kind: "freedom", targets: toTargets(design.handles) })
      .then(
        (answer) => {
          if (answer.kind === "freedom" && page.history.peek()?.present === design)
            page.freedom.value = answer.freedom;
        },
        () => {
          page.freedom.value = null;
        },
      );
  });
}
