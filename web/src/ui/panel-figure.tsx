// SPDX-License-Identifier: MIT
import { flatnessWords } from "../state/flatness.ts";
import { OUTLINES } from "../state/panel-rows.ts";
import { mesh, panelFigures, panelHealth, selectedPanel, unit } from "../state/store.ts";
import { formatLength } from "../state/units.ts";

/** ", convex, smallest angle 87°, shortest edge 604 mm"; "" while nothing is measured. */
function shapeWords(panel: number): string {
  const [outline, edge, angle] = panelHealth.value?.subarray(4 * panel, 4 * panel + 3) ?? [];
  if (outline === undefined || edge === undefined || angle === undefined) return "";
  return `, ${OUTLINES[outline]}, smallest angle ${angle.toFixed(0)}°, shortest edge ${formatLength(edge, unit.value)}`;
}

/** What is worth knowing about the selected panel, beside it. */
export function PanelFigure() {
  const panel = selectedPanel.value;
  const offsets = mesh.value?.offsets;
  if (panel === null || !offsets) return null;
  const corners = (offsets[panel + 1] ?? 0) - (offsets[panel] ?? 0);
  const [gap, mmPerM, excess] = panelFigures.value?.subarray(3 * panel, 3 * panel + 3) ?? [];
  return (
    <span>
      <strong>Panel {panel}</strong> {corners} corners
      {gap !== undefined &&
        mmPerM !== undefined &&
        excess !== undefined &&
        `, ${flatnessWords(gap, mmPerM, excess, unit.value).sentence}`}
      {shapeWords(panel)}
    </span>
  );
}
