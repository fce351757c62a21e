// SPDX-License-Identifier: MIT
import { worstPanels } from "../state/analysis.ts";
import { panelFigures, selectedPanel, unit } from "../state/store.ts";
import { formatGap } from "../state/units.ts";

const ROWS = 6;

const perMetre = (value: number): string =>
  value < 1e-3 ? value.toExponential(1) : value.toPrecision(3);

/** The panels furthest from flat; choosing one shows it. */
export function PanelsTable() {
  const figures = panelFigures.value;
  if (!figures) return null;
  return (
    <table class="panels" aria-label="Panels">
      <caption>Furthest from flat</caption>
      <thead>
        <tr>
          <th scope="col">Panel</th>
          <th scope="col">Out of flat</th>
          <th scope="col">mm/m</th>
        </tr>
      </thead>
      <tbody>
        {worstPanels(figures, ROWS).map(({ panel, gap, mmPerM }) => (
          <tr key={panel} class={panel === selectedPanel.value ? "selected" : ""}>
            <th scope="row">
              <button
                type="button"
                class="point-button"
                aria-label={`Show panel ${panel}`}
                onClick={() => {
                  selectedPanel.value = panel;
                }}
              >
                {panel}
              </button>
            </th>
            <td>{formatGap(gap, unit.value)}</td>
            <td>{perMetre(mmPerM)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
