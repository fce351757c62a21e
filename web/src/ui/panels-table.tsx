// SPDX-License-Identifier: MIT
import "./panels.css";
import { useSignal } from "@preact/signals";
import {
  countHealth,
  firstPanels,
  OUTLINES,
  type PanelColumn,
  type PanelRow,
} from "../state/analysis.ts";
import { FLAT_MEANS, flatnessWords } from "../state/flatness.ts";
import { panelFigures, panelHealth, selectedPanel, unit } from "../state/store.ts";
import { convert } from "../state/units.ts";

const ROWS = 8;

interface Column {
  readonly key: PanelColumn;
  readonly name: string;
  readonly unit?: string;
  /** Whether the first click brings the largest to the top. */
  readonly largest: boolean;
}

const COLUMNS: readonly Column[] = [
  { key: "panel", name: "Panel", largest: false },
  { key: "gap", name: "Out of flat", unit: "mm", largest: true },
  { key: "mmPerM", name: "mm/m", largest: true },
  { key: "angle", name: "Angle", largest: false },
  { key: "edge", name: "Edge", unit: "mm", largest: false },
  { key: "outline", name: "Shape", largest: true },
];

const panels = (count: number): string => `${count} ${count === 1 ? "panel" : "panels"}`;

function Summary({ health }: { health: Float32Array }) {
  const { changed, concave, crossing } = countHealth(health);
  return (
    <p class="quiet">
      {`${panels(changed)} must be made again after this edit; ${concave} concave, ${crossing} self-crossing (bow-tie).`}
    </p>
  );
}

function Row({ row }: { row: PanelRow }) {
  const { panel, angle, edge, outline } = row;
  const { gap, cell } = flatnessWords(row.gap, row.mmPerM, unit.value);
  return (
    <tr class={panel === selectedPanel.value ? "selected" : ""}>
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
      <td>{gap.replace(" mm", "")}</td>
      <td>{cell}</td>
      <td>{`${angle.toFixed(0)}°`}</td>
      <td>{convert(edge, unit.value, "mm").toFixed(0)}</td>
      <td class={outline === 0 ? "" : "unhealthy"}>{OUTLINES[outline]}</td>
    </tr>
  );
}

/** Every panel's figures, first those that matter by the chosen column; choosing one shows it. */
export function PanelsTable() {
  const order = useSignal<{ key: PanelColumn; descending: boolean }>({
    key: "mmPerM",
    descending: true,
  });
  const [figures, health] = [panelFigures.value, panelHealth.value];
  if (!figures || health?.length !== 2 * figures.length) return null;
  const { key, descending } = order.value;
  const sort = (column: Column): void => {
    const again = column.key === key;
    order.value = { key: column.key, descending: again ? !descending : column.largest };
  };
  return (
    <>
      <Summary health={health} />
      <div class="panels-frame">
        <table class="panels" aria-label="Panels">
          <thead>
            <tr>
              {COLUMNS.map((column) => (
                <th
                  key={column.key}
                  scope="col"
                  aria-sort={column.key !== key ? "none" : descending ? "descending" : "ascending"}
                >
                  <button type="button" class="sort-button" onClick={() => sort(column)}>
                    {column.name}
                    <span aria-hidden="true">
                      {column.key === key ? (descending ? " ↓" : " ↑") : ""}
                    </span>
                    {column.unit && <span class="column-unit">{column.unit}</span>}
                  </button>
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {firstPanels(figures, health, key, descending, ROWS).map((row) => (
              <Row key={row.panel} row={row} />
            ))}
          </tbody>
        </table>
      </div>
      <p class="quiet small">{FLAT_MEANS}</p>
    </>
  );
}
