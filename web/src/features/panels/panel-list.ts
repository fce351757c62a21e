// SPDX-License-Identifier: MIT
// The table of panels as a file for spreadsheets.
import type { Kind } from "../../design/kept-kind.ts";
import { convert, type Unit } from "../../quantity/units.ts";
import { type MeasuredPanels, panelCount, rowOf } from "../../state/panel-rows.ts";
import { TROUBLES } from "../../state/panel-trouble.ts";

const COLUMNS = [
  "panel",
  "out_of_flat_mm",
  "out_of_flat_mm_per_m",
  "smallest_angle_deg",
  "shortest_edge_mm",
  "shape",
  "sharpest_fold_deg",
  "must_be_made_again",
] as const;

/** By the core's PanelChange. */
const REMAKE = ["no", "yes", "bevel"] as const;

/** As many digits as were measured. */
const digits = (value: number): string => String(Number(value.toPrecision(7)));

/** One line a panel in their order, after one that names the columns; lines end as RFC 4180 says.
 * @param kind whose defects were measured */
export function panelList(panels: MeasuredPanels, unit: Unit, kind: Kind | null): string {
  const mm = (length: number): string => digits(convert(length, unit, "mm"));
  const columns = kind ? [...COLUMNS, `${kind}_defect_deg`] : COLUMNS;
  const lines = Array.from({ length: panelCount(panels.figures) }, (_, panel) => {
    const row = rowOf(panel, panels);
    const shape = TROUBLES[row.trouble] ?? "";
    const again = REMAKE[row.changed] ?? "";
    const missed = row.defect < 0 ? "" : digits(row.defect);
    return [
      ...[panel, mm(row.gap), digits(row.mmPerM), digits(row.angle), mm(row.edge)],
      ...[shape, digits(row.fold), again],
      ...(kind ? [missed] : []),
    ];
  });
  return [columns, ...lines].map((line) => `${line.join(",")}\r\n`).join("");
}
