// SPDX-License-Identifier: MIT
// Which points are chosen: the latest is the one that the arrows stand at.
import { draft, selectedPanel, selection, visited } from "./store.ts";

export function selectOnly(vertex: number): void {
  selection.value = [vertex];
}

export function toggleSelected(vertex: number): void {
  selection.value = selection.value.includes(vertex)
    ? selection.value.filter((v) => v !== vertex)
    : [...selection.value, vertex];
}

/** Adds points to those that are chosen; `first` of them leads. */
export function selectAlso(vertices: readonly number[]): void {
  const kept = selection.value.filter((v) => !vertices.includes(v));
  selection.value = [...kept, ...vertices];
}

/** Instead of those that were chosen; none of them clears the selection. */
export function selectThese(vertices: readonly number[]): void {
  selection.value = vertices;
}

export function selectHandles(): void {
  selection.value = (draft.value?.handles ?? []).map((row) => row.vertex);
}

export function visit(vertex: number | null): void {
  visited.value = vertex;
}

/** The panel after the selected one among `panels`, from the first again; comes into view. */
export function showNextPanel(panels: readonly number[]): void {
  const next = panels[(panels.indexOf(selectedPanel.value ?? -1) + 1) % panels.length] ?? null;
  selectedPanel.value = null;
  selectedPanel.value = next;
}

export function deselect(): void {
  selection.value = [];
  selectedPanel.value = null;
}
