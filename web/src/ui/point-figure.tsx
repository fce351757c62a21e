// SPDX-License-Identifier: MIT

import { formatLength } from "../quantity/units.ts";
import { movesOn } from "../state/moves.ts";
import type { Page } from "../state/page.ts";
import { usePage } from "./page-context.ts";

/** What the colour at a point stands for, in words. */
export function meaning(page: Page, vertex: number): string {
  const [opened, design] = [page.mesh.value, page.draft.value];
  const bend = page.colourBy.value === "fairness" ? page.bending.value?.[vertex] : undefined;
  if (bend !== undefined)
    return bend > 0 ? `bends ${formatLength(bend, page.unit.value)}` : "smooth";
  // The view has been told of every move by the time that the report comes.
  page.figures.value;
  const length = opened && design && movesOn(page, opened, design.shape).lengths.get(vertex);
  return length ? `moved ${formatLength(length, page.unit.value)}` : "untouched";
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
