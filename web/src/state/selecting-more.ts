// SPDX-License-Identifier: MIT
// Selections that follow from the mesh, or from what is selected.
import {
  type Edge,
  type LinedMesh,
  lineThrough,
  neighboursOf,
  ringThrough,
} from "../mesh/mesh-lines.ts";
import type { Topology } from "../mesh/topology.ts";
import { selectAlso, selectThese } from "./selection.ts";
import { displayMesh, selection } from "./store.ts";

/** Edges are told apart by the mesh as it was opened. */
export function linedMesh(): LinedMesh | null {
  const shown = displayMesh.value;
  return shown && { ...shown, points: shown.display };
}

const everyVertex = ({ boundary }: Topology): number[] => [...boundary.keys()];

export function selectBoundary(): void {
  const topology = displayMesh.value?.topology;
  if (topology) selectAlso(everyVertex(topology).filter((v) => topology.boundary[v] === 1));
}

/** The two points selected last, if they are neighbours. */
export function selectedEdge(): Edge | null {
  const topology = displayMesh.value?.topology;
  const [a, b] = selection.value.slice(-2);
  if (!topology || a === undefined || b === undefined) return null;
  return neighboursOf(topology, a).includes(b) ? [a, b] : null;
}

const selectThrough = (through: (mesh: LinedMesh, edge: Edge) => number[]) => (): void => {
  const [mesh, edge] = [linedMesh(), selectedEdge()];
  if (mesh && edge) selectAlso(through(mesh, edge));
};

export const selectLine = selectThrough(lineThrough);
export const selectRing = selectThrough(ringThrough);

export function selectOthers(): void {
  const topology = displayMesh.value?.topology;
  const chosen = new Set(selection.value);
  if (topology) selectThese(everyVertex(topology).filter((v) => !chosen.has(v)));
}

export function growSelection(): void {
  const topology = displayMesh.value?.topology;
  if (!topology) return;
  const grown = new Set(selection.value.flatMap((v) => neighboursOf(topology, v)));
  selectThese([...new Set([...grown, ...selection.value])]);
}

export function shrinkSelection(): void {
  const topology = displayMesh.value?.topology;
  if (!topology) return;
  const chosen = new Set(selection.value);
  const inside = (v: number): boolean => neighboursOf(topology, v).every((n) => chosen.has(n));
  selectThese(selection.value.filter(inside));
}
