// SPDX-License-Identifier: MIT

import { formatLength } from "../quantity/units.ts";
import { movesShown } from "../state/moves.ts";
import type { Page } from "../state/page.ts";
import { usePage } from "./page-context.ts";

/** What the colour at a point stands for, in words. */
export function meaning(page: Page, vertex: number): string {
  const bend = page.colourBy.value === "fairness" ? page.bending.value?.[vertex] : undefined;
  if (bend !== undefined)
    return bend > 0 ? `bends ${formatLength(bend, page.unit.value)}` : "smooth";
  const moves = movesShown(page);
  const length = moves?.lengths.get(vertex);
  if (!moves || !length) return "untouched";
  const words = `moved ${formatLength(length, page.unit.value)}`;
  const kind = page.colourBy.value;
  if (kind !== "shape" && kind !== "slide") return words;
  const figure = moves.motionOf(vertex)[kind];
  const part = kind === "slide" ? "slid" : figure < 0 ? "lowered" : "raised";
  return `${words}, ${part} ${formatLength(Math.abs(figure), page.unit.value)}`;
}

/** The figure of the point that is dragged, else that the pointer rests on, else chosen last. */
export function PointFigure() {
  const page = usePage();
  const pull = page.pull.value;
  const vertex = pull?.vertex ?? page.visited.value ?? page.selected.value;
  if (vertex === null) return null;
  return (
    <span>
      <strong>Point {vertex}</strong> {meaning(page, vertex)}
      {pull?.typed && ` · typed ${pull.typed} ${page.unit.value}`}
    </span>
  );
}
