// SPDX-License-Identifier: MIT

import { flatnessWords } from "../../design/flatness.ts";
import { formatLength } from "../../quantity/units.ts";
import { formatDegrees } from "../../state/fold.ts";
import { measuredPanels } from "../../state/measured-panels.ts";
import type { Page } from "../../state/page.ts";
import { type PanelRow, rowOf } from "../../state/panel-rows.ts";
import { TROUBLES } from "../../state/panel-trouble.ts";
import { usePage } from "../../ui/page-context.ts";

/** ", convex, smallest angle 87°, shortest edge 604 mm, sharpest fold 8.4°" */
function shapeWords(page: Page, { trouble, angle, edge, fold }: PanelRow): string {
  return `, ${TROUBLES[trouble]}, smallest angle ${angle.toFixed(0)}°, shortest edge ${formatLength(edge, page.unit.value)}, sharpest fold ${formatDegrees(fold)}`;
}

/** What is worth knowing about the selected panel, beside it. */
export function PanelFigure() {
  const page = usePage();
  const panel = page.selectedPanel.value;
  const offsets = page.mesh.value?.offsets;
  if (panel === null || !offsets) return null;
  const corners = (offsets[panel + 1] ?? 0) - (offsets[panel] ?? 0);
  const measured = measuredPanels(page).value;
  const row = measured && rowOf(panel, measured);
  return (
    <span>
      <strong>Panel {panel}</strong> {corners} corners
      {row &&
        `, ${flatnessWords(row.gap, row.mmPerM, row.excess, page.unit.value).sentence}${shapeWords(page, row)}`}
    </span>
  );
}
