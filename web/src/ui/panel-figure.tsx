// SPDX-License-Identifier: MIT
import { flatnessWords } from "../state/flatness.ts";
import { formatDegrees } from "../state/fold.ts";
import { measuredPanels } from "../state/measured-panels.ts";
import { type PanelRow, rowOf } from "../state/panel-rows.ts";
import { TROUBLES } from "../state/panel-trouble.ts";
import { mesh, selectedPanel, unit } from "../state/store.ts";
import { formatLength } from "../state/units.ts";

/** ", convex, smallest angle 87°, shortest edge 604 mm, sharpest fold 8.4°" */
function shapeWords({ trouble, angle, edge, fold }: PanelRow): string {
  return `, ${TROUBLES[trouble]}, smallest angle ${angle.toFixed(0)}°, shortest edge ${formatLength(edge, unit.value)}, sharpest fold ${formatDegrees(fold)}`;
}

/** What is worth knowing about the selected panel, beside it. */
export function PanelFigure() {
  const panel = selectedPanel.value;
  const offsets = mesh.value?.offsets;
  if (panel === null || !offsets) return null;
  const corners = (offsets[panel + 1] ?? 0) - (offsets[panel] ?? 0);
  const row = measuredPanels.value && rowOf(panel, measuredPanels.value);
  return (
    <span>
      <strong>Panel {panel}</strong> {corners} corners
      {row &&
        `, ${flatnessWords(row.gap, row.mmPerM, row.excess, unit.value).sentence}${shapeWords(row)}`}
    </span>
  );
}
