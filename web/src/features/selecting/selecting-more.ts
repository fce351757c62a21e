// SPDX-License-Identifier: MIT
// Selections that follow from the mesh, or from what is selected.

import {
  type Edge,
  type LinedMesh,
  lineThrough,
  neighboursOf,
  ringThrough,
} from "../../mesh/mesh-lines.ts";
import type { Topology } from "../../mesh/topology.ts";
import type { Page } from "../../state/page.ts";
import { selectAlso, selectThese } from "../../state/selection.ts";

/** Edges are told apart by the mesh as it was opened. */
function linedMesh(page: Page): LinedMesh | null {
  const shown = page.displayMesh.value;
  return shown && { ...shown, points: shown.display };
}

const everyVertex = ({ boundary }: Topology): number[] => [...boundary.keys()];

export function selectBoundary(page: Page): void {
  const topology = page.displayMesh.value?.topology;
  if (topology)
    selectAlso(
      page,
      everyVertex(topology).filter((v) => topology.boundary[v] === 1),
    );
}

/** The two points selected last, if they are neighbours. */
export function selectedEdge(page: Page): Edge | null {
  const topology = page.displayMesh.value?.topology;
  const [a, b] = page.selection.value.slice(-2);
  if (!topology || a === undefined || b === undefined) return null;
  return neighboursOf(topology, a).includes(b) ? [a, b] : null;
}

const selectThrough =
  (through: (mesh: LinedMesh, edge: Edge) => number[]) =>
  (page: Page): void => {
    const [mesh, edge] = [linedMesh(page), selectedEdge(page)];
    if (mesh && edge) selectAlso(page, through(mesh, edge));
  };

export const selectLine = selectThrough(lineThrough);

export const selectRing = selectThrough(ringThrough);

export function selectOthers(page: Page): void {
  const topology = page.displayMesh.value?.topology;
  const chosen = new Set(page.selection.value);
  if (topology)
    selectThese(
      page,
      everyVertex(topology).filter((v) => !chosen.has(v)),
    );
}

export function growSelection(page: Page): void {
  const topology = page.displayMesh.value?.topology;
  if (!topology) return;
  const grown = new Set(page.selection.value.flatMap((v) => neighboursOf(topology, v)));
  selectThese(page, [...new Set([...grown, ...page.selection.value])]);
}

export function shrinkSelection(page: Page): void {
  const topology = page.displayMesh.value?.topology;
  if (!topology) return;
  const chosen = new Set(page.selection.value);
  const inside = (v: number): boolean => neighboursOf(topology, v).every((n) => chosen.has(n));
  selectThese(page, page.selection.value.filter(inside));
}
