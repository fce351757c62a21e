// SPDX-License-Identifier: MIT
// What points are listed to stand on, and to change it.
import { effect } from "@preact/signals";
import { FIRST_SETTINGS } from "../../design/design.ts";
import { formsByPoint, POLYLINE, withPoints } from "../../design/listed-supports.ts";
import { polylineOf } from "../../mesh/polyline.ts";
import type { Outcome } from "../../state/action-queue.ts";
import { commitSettings } from "../../state/editing.ts";
import type { Page } from "../../state/page.ts";

const supportsOf = (page: Page): readonly string[] =>
  (page.settings.value ?? FIRST_SETTINGS).supports;

/** Points that are listed, with what they stand on: its forms, joined by spaces. */
export const standing = (page: Page): ReadonlyMap<number, string> =>
  new Map([...formsByPoint(supportsOf(page))].map(([vertex, forms]) => [vertex, forms.join(" ")]));

/** What all selected points stand on; null where they differ. */
export function standOfSelected(page: Page): string | null {
  const stands = standing(page);
  const [first = "", ...others] = page.selection.value.map((vertex) => stands.get(vertex) ?? "");
  return others.every((other) => other === first) ? first : null;
}

/** Whether all selected points are of the boundary. */
export function isBoundarySelected(page: Page): boolean {
  const boundary = page.mesh.value?.topology.boundary;
  return page.selection.value.every((vertex) => boundary?.[vertex] === 1);
}

function lineThrough(page: Page, vertices: readonly number[]): readonly number[] | null {
  const topology = page.mesh.value?.topology;
  return topology ? polylineOf(topology, vertices) : null;
}

/** Whether all selected points are one line of the mesh. */
export const isLineSelected = (page: Page): boolean =>
  lineThrough(page, page.selection.value) !== null;

/** @param stand forms, joined by spaces; "" to let them move freely; a line needs points of one */
export function standOn(page: Page, vertices: readonly number[], stand: string): Outcome {
  const points = stand === POLYLINE ? lineThrough(page, vertices) : vertices;
  const forms = stand ? stand.split(" ") : [];
  return commitSettings(page, {
    supports: withPoints(supportsOf(page), points ?? vertices, forms),
  });
}

/** Shows the marks of points that stand on something. */
export const followSupports = (page: Page): (() => void) =>
  effect(() => {
    page.supported.value = [...standing(page).keys()];
  });
