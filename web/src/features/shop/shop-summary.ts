// SPDX-License-Identifier: MIT
// What was saved for the workshop, in words.

import { decimal, FLAT } from "../../design/flatness.ts";
import { counted } from "../../quantity/counted.ts";
import type { CuttingHeader } from "../../solver/protocol.ts";

function sheetWords({ sheets }: CuttingHeader): string[] {
  if (!sheets) return [];
  const used = Math.round(100 * sheets.used_fraction);
  const words = [`${counted(sheets.count, "sheet")}, ${used} % used`];
  if (sheets.oversize.length > 0)
    words.push(`${counted(sheets.oversize.length, "panel")} larger than a sheet`);
  return words;
}

/** What the joint does to panels beside making them smaller. */
function gapWords({ apart = [], lost_sides = [] }: CuttingHeader): string[] {
  const words: string[] = [];
  if (apart.length > 0) {
    const each = apart.map(({ panel, pieces }) => `${panel} (${pieces} pieces)`);
    words.push(`the joint cuts into pieces: ${each.join(", ")}`);
  }
  if (lost_sides.length > 0) words.push(`the joint takes whole sides of ${lost_sides.join(", ")}`);
  return words;
}

export function summary(header: CuttingHeader): string {
  const { counts, remake, types, vanished, labels, flatness_mm_per_m, excess_mm_per_m } = header;
  const parts = [
    `${counted(counts.drawn, "panel")} drawn${types ? ` as ${counted(types.types, "type")}` : ""}`,
  ];
  if (remake)
    parts.push(
      `${remake.outline} to be cut again, ${remake.bevel} with a new bevel only`,
      `${remake.nodes_moved} nodes moved, ${remake.nodes_arms} with new angles only`,
    );
  parts.push(...sheetWords(header));
  if (labels?.link && !labels.code)
    parts.push("the labels carry no QR code, as the link is too long for one");
  if (vanished.length > 0)
    parts.push(
      `not drawn, as nothing is left of them or they cross themselves: ${vanished.join(", ")}`,
    );
  parts.push(...gapWords(header));
  if (excess_mm_per_m > FLAT)
    parts.push(`not flat: a panel is out of its plane by ${decimal(flatness_mm_per_m)} mm/m`);
  return `${parts.join("; ")}.`;
}
