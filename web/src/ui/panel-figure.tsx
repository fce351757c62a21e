// SPDX-License-Identifier: MIT
import { mesh, panelFigures, selectedPanel, unit } from "../state/store.ts";
import { formatGap } from "../state/units.ts";

/** What is worth knowing about the selected panel, beside it. */
export function PanelFigure() {
  const panel = selectedPanel.value;
  const offsets = mesh.value?.offsets;
  if (panel === null || !offsets) return null;
  const corners = (offsets[panel + 1] ?? 0) - (offsets[panel] ?? 0);
  const gap = panelFigures.value?.[2 * panel];
  return (
    <span>
      <strong>Panel {panel}</strong> {corners} corners
      {gap !== undefined && `, ${formatGap(gap, unit.value)} out of flat`}
    </span>
  );
}
