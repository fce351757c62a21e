// SPDX-License-Identifier: MIT

import { counted } from "../../quantity/counted.ts";
import { Check } from "../../ui/check.tsx";
import { usePage } from "../../ui/page-context.ts";
import "./panels.css";
import { sliverAngle } from "virtual:core-defaults";
import { useSignal } from "@preact/signals";
import { FLAT_MEANS, flatnessWords } from "../../design/flatness.ts";
import { type Kind, LEAST_DEFECT } from "../../design/kept-kind.ts";
import { save } from "../../export/exporting.ts";
import { convert } from "../../quantity/units.ts";
import { PER_PANEL } from "../../solver/protocol.ts";
import { formatDegrees } from "../../state/fold.ts";
import { measuredPanels } from "../../state/measured-panels.ts";
import {
  countHealth,
  firstPanels,
  type PanelColumn,
  type PanelOrder,
  type PanelRow,
  panelCount,
} from "../../state/panel-rows.ts";
import { TROUBLES } from "../../state/panel-trouble.ts";
import { PanelButton } from "../../ui/panel-button.tsx";
import { panelList } from "./panel-list.ts";

const ROWS = 8;

const MORE = 50;

interface Column {
  readonly key: PanelColumn;
  readonly name: string;
  readonly unit?: string;
  readonly meaning: string;
  /** Whether the first click brings the largest to the top. */
  readonly largest: boolean;
}

const COLUMNS: readonly Column[] = [
  { key: "panel", name: "Panel", meaning: "Number of the panel, from 0", largest: false },
  {
    key: "gap",
    name: "Out of flat",
    unit: "mm",
    meaning: "Distance of the two planes, parallel to the best-fit plane, that hold all corners",
    largest: true,
  },
  {
    key: "mmPerM",
    name: "mm/m",
    meaning: "Out of flat, divided by the panel's longest edge",
    largest: true,
  },
  {
    key: "angle",
    name: "Least angle",
    meaning: "The panel's smallest inner angle",
    largest: false,
  },
  {
    key: "edge",
    name: "Least edge",
    unit: "mm",
    meaning: "Length of the panel's shortest edge",
    largest: false,
  },
  {
    key: "urgency",
    name: "Shape",
    meaning: `What is wrong with the panel: the worst first, then by the sharpest fold; a sliver has a corner below ${sliverAngle}°`,
    largest: true,
  },
  {
    key: "fold",
    name: "Fold",
    unit: "°",
    meaning: "The panel's sharpest fold with a neighbour",
    largest: true,
  },
];

const MISSED: Readonly<Record<Kind, Column>> = {
  circular: {
    key: "defect",
    name: "Circular",
    unit: "°",
    meaning: "By how much opposite angles miss 180°",
    largest: true,
  },
  conical: {
    key: "defect",
    name: "Conical",
    unit: "°",
    meaning: "By how much the panel's worst node misses its cone",
    largest: true,
  },
};

/** A kind that is looked at takes the place of the distance: the table is no wider. */
const columnsFor = (kind: Kind | null): readonly Column[] =>
  kind ? COLUMNS.map((column) => (column.key === "gap" ? MISSED[kind] : column)) : COLUMNS;

/** Two digits, as a kind's figures are everywhere; rounding alone is 0. */
const defectWords = (degrees: number): string =>
  degrees < 0 ? "–" : degrees < LEAST_DEFECT ? "0" : String(Number(degrees.toPrecision(2)));

function Summary({ health }: { health: Float32Array }) {
  const page = usePage();
  const { changed, bevel, concave, crossing } = countHealth(health);
  const only = bevel > 0 ? `, ${bevel} of them with a new bevel only` : "";
  const { moved, arms } = page.nodeCounts.value ?? { moved: 0, arms: 0 };
  const nodes =
    moved + arms > 0
      ? `, and ${counted(moved + arms, "node")}, ${arms} of them with new angles only`
      : "";
  return (
    <p class="quiet">
      {`${counted(changed, "panel")} must be made again after this edit${only}${nodes}; ${concave} concave, ${crossing} self-crossing (bow-tie).`}
    </p>
  );
}

function Row({ row, kind }: { row: PanelRow; kind: Kind | null }) {
  const page = usePage();
  const { panel, angle, edge, trouble, fold } = row;
  const { gap, cell } = flatnessWords(row.gap, row.mmPerM, row.excess, page.unit.value);
  return (
    <tr class={panel === page.selectedPanel.value ? "selected" : ""}>
      <th scope="row">
        <PanelButton panel={panel} />
      </th>
      <td>{kind ? defectWords(row.defect) : gap.replace(" mm", "")}</td>
      <td>{cell}</td>
      <td>{`${angle.toFixed(0)}°`}</td>
      <td>{convert(edge, page.unit.value, "mm").toFixed(0)}</td>
      <td class={trouble === 0 ? "" : "unhealthy"}>{TROUBLES[trouble]}</td>
      <td>{formatDegrees(fold).replace("°", "")}</td>
    </tr>
  );
}

interface HeadProps {
  readonly columns: readonly Column[];
  readonly order: PanelOrder;
  readonly onSort: (column: Column) => void;
}

function Head({ columns, order: { key, descending }, onSort }: HeadProps) {
  return (
    <thead>
      <tr>
        {columns.map((column) => (
          <th
            key={column.key}
            scope="col"
            class={`column-${column.key}`}
            aria-sort={column.key !== key ? "none" : descending ? "descending" : "ascending"}
          >
            <button
              type="button"
              class="sort-button"
              title={column.meaning}
              onClick={() => onSort(column)}
            >
              {column.name}
              {column.unit && (
                <>
                  {" "}
                  <span class="column-unit">{column.unit}</span>
                </>
              )}
              <span class="sort-arrow" aria-hidden="true">
                {column.key === key ? (descending ? "↓" : "↑") : ""}
              </span>
            </button>
          </th>
        ))}
      </tr>
    </thead>
  );
}

/** Every panel's figures, first those in trouble, or by the chosen column; choosing one shows it. */
export function PanelsTable() {
  const page = usePage();
  const order = useSignal<PanelOrder>({ key: "urgency", descending: true, changedOnly: false });
  const wanted = useSignal(ROWS);
  const measured = measuredPanels(page).value;
  if (!measured) return null;
  const { figures, health } = measured;
  if (health.length !== PER_PANEL.health * panelCount(figures)) return null;
  const kind = page.kindDefects.value?.kind ?? null;
  const { key, descending, changedOnly } = order.value;
  const sort = (column: Column): void => {
    const again = column.key === key;
    const down = again ? !descending : column.largest;
    order.value = { key: column.key, descending: down, changedOnly };
  };
  const rows = firstPanels(measured, order.value, wanted.value);
  const total = changedOnly ? countHealth(health).changed : panelCount(figures);
  const more = Math.min(MORE, total - rows.length);
  return (
    <>
      <Summary health={health} />
      <Check
        label="Only panels that must be made again"
        checked={changedOnly}
        onChange={(on) => {
          order.value = { key, descending, changedOnly: on };
        }}
      />
      <div class="panels-frame">
        <table class="panels" aria-label="Panels">
          <Head columns={columnsFor(kind)} order={order.value} onSort={sort} />
          <tbody>
            {rows.map((row) => (
              <Row key={row.panel} row={row} kind={kind} />
            ))}
          </tbody>
        </table>
      </div>
      <div class="panels-more">
        <span class="quiet small">
          {`${rows.length} of ${counted(total, "panel")}; `}
          <span class="whole">{FLAT_MEANS}</span>
        </span>
        <button
          type="button"
          class="button small"
          title="Saves the table of all panels, for spreadsheets"
          onClick={() => {
            const text = panelList(measured, page.unit.value, kind);
            save(page, new Blob([text], { type: "text/csv" }), "-panels.csv");
          }}
        >
          Save CSV
        </button>
        {more > 0 && (
          <button
            type="button"
            class="button small"
            onClick={() => {
              wanted.value = rows.length + MORE;
            }}
          >
            Show {more} more
          </button>
        )}
      </div>
    </>
  );
}
