// SPDX-License-Identifier: MIT
// What was measured of every panel, in one place for tables and lists.

import { computed } from "@preact/signals";
import type { Polygons } from "../mesh/display-mesh.ts";
import { kept } from "./page.ts";
import type { MeasuredPanels } from "./panel-rows.ts";
import { urgencyOf } from "./panel-trouble.ts";

/** The worst defect at the points of every panel; -1 where none is bound. */
export function worstOfPoints(
  defects: Float32Array,
  faces: Pick<Polygons, "offsets" | "vertices">,
) {
  const { offsets, vertices } = faces;
  return Float32Array.from({ length: offsets.length - 1 }, (_, panel) =>
    vertices
      .subarray(offsets[panel], offsets[panel + 1])
      .reduce((worst, v) => Math.max(worst, defects[v] ?? -1), -1),
  );
}

export const measuredPanels = kept((page) =>
  computed((): MeasuredPanels | null => {
    const [figures, health, faces] = [
      page.panelFigures.value,
      page.panelHealth.value,
      page.mesh.value,
    ];
    const [troubles, folds] = [page.panelTroubles.value, page.panelFolds.value];
    if (!figures || !health || !troubles || !faces) return null;
    const missed = page.kindDefects.value;
    const defects =
      missed?.kind === "conical" ? worstOfPoints(missed.values, faces) : missed?.values;
    const urgency = urgencyOf(troubles, figures, folds);
    return { figures, health, troubles, urgency, folds, defects: defects ?? null };
  }),
);
