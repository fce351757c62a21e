// SPDX-License-Identifier: MIT
// Which points are chosen: the latest is the one that the arrows stand at.
import type { Page } from "./page.ts";
export function selectOnly(page: Page, vertex: number): void {
  page.selection.value = [vertex];
}

export function toggleSelected(page: Page, vertex: number): void {
  page.selection.value = page.selection.value.includes(vertex)
    ? page.selection.value.filter((v) => v !== vertex)
    : [...page.selection.value, vertex];
}

/** Adds points to those that are chosen; `first` of them leads. */
export function selectAlso(page: Page, vertices: readonly number[]): void {
  const kept = page.selection.value.filter((v) => !vertices.includes(v));
  page.selection.value = [...kept, ...vertices];
}

/** Instead of those that were chosen; none of them clears the selection. */
export function selectThese(page: Page, vertices: readonly number[]): void {
  page.selection.value = vertices;
}

export function selectHandles(page: Page): void {
  page.selection.value = (page.draft.value?.handles ?? []).map((row) => row.vertex);
}

export function visit(page: Page, vertex: number | null): void {
  page.visited.value = vertex;
}

/** The panel after the selected one among `panels`, from the first again; comes into view. */
export function showNextPanel(page: Page, panels: readonly number[]): void {
  const next = panels[(panels.indexOf(page.selectedPanel.value ?? -1) + 1) % panels.length] ?? null;
  page.selectedPanel.value = null;
  page.selectedPanel.value = next;
}

export function deselect(page: Page): void {
  page.selection.value = [];
  page.selectedPanel.value = null;
}
