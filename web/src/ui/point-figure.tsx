// SPDX-License-Identifier: MIT
import { movesOn } from "../state/moves.ts";
import {
  bending,
  colourBy,
  draft,
  figures,
  mesh,
  selected,
  unit,
  visited,
} from "../state/store.ts";
import { formatLength } from "../state/units.ts";

/** What the colour at a point stands for, in words. */
export function meaning(vertex: number): string {
  const [opened, design] = [mesh.value, draft.value];
  const bend = colourBy.value === "fairness" ? bending.value?.[vertex] : undefined;
  if (bend !== undefined) return bend > 0 ? `bends ${formatLength(bend, unit.value)}` : "smooth";
  // The view has been told of every move by the time that the report comes.
  figures.value;
  const length = opened && design && movesOn(opened, design.shape).lengths.get(vertex);
  return length ? `moved ${formatLength(length, unit.value)}` : "untouched";
}

/** The figure of the point that the pointer rests on, else of the one chosen last. */
export function PointFigure() {
  const vertex = visited.value ?? selected.value;
  if (vertex === null) return null;
  return (
    <span>
      <strong>Point {vertex}</strong> {meaning(vertex)}
    </span>
  );
}
