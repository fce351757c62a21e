// SPDX-License-Identifier: MIT
import { flatnessWords } from "../state/flatness.ts";
import { mesh, panelFigures, selectedPanel, unit } from "../state/store.ts";

/** What is worth knowing about the selected panel, beside it. */
export function PanelFigure() {
  const panel = selectedPanel.value;
  const offsets = mesh.value?.offsets;
  if (panel === null || !offsets) return null;
  const corners = (offsets[panel + 1] ?? 0) - (offsets[panel] ?? 0);
  const [gap, mmPerM] = panelFigures.value?.subarray(2 * panel, 2 * panel + 2) ?? [];
  return (
    <span>
      <strong>Panel {panel}</strong> {corners} corners
      {gap !== undefined &&
        mmPerM !== undefined &&
        `, ${flatnessWords(gap, mmPerM, unit.value).sentence}`}
    </span>
  );
}
