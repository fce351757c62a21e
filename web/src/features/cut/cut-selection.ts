// SPDX-License-Identifier: MIT
// What the selection says of a cut: its numbers, as they would be typed; "" where it says nothing.
import type { Point } from "../../design/design.ts";
import type { DisplayMesh } from "../../mesh/display-mesh.ts";
import { neighboursOf } from "../../mesh/mesh-lines.ts";
import { row } from "../../mesh/topology.ts";
import { panelAt } from "../../mesh/triangulation.ts";
import { cross, minus } from "../../mesh/vector.ts";
import { basePoint } from "../../state/editing.ts";
import { selectedMembers } from "../../state/groups.ts";
import type { Page } from "../../state/page.ts";
import { sectionPlane } from "../../state/shown-section.ts";
import type { CutKind } from "./cut-text.ts";

const panelsAt = ({ offsets, topology }: DisplayMesh, vertex: number): number[] =>
  [...row(topology.corners, vertex)].map((corner) => panelAt(offsets, corner));

const lastTwo = (page: Page): readonly (number | undefined)[] => page.selection.value.slice(-2);

/** The two points selected last, on a panel that has both. */
function split(page: Page, mesh: DisplayMesh): string {
  const [a, b] = lastTwo(page);
  if (a === undefined || b === undefined) return "";
  const there = panelsAt(mesh, b);
  const panel = panelsAt(mesh, a).find((one) => there.includes(one));
  return panel === undefined ? "" : `${panel}:${a},${b}`;
}

function strip(page: Page, mesh: DisplayMesh): string {
  const [a, b] = lastTwo(page);
  if (a === undefined || b === undefined) return "";
  return neighboursOf(mesh.topology, a).includes(b) ? `${a}-${b}` : "";
}

/** The point selected last, on the first panel there. */
function corner(page: Page, mesh: DisplayMesh): string {
  const vertex = page.selected.value;
  const panel = vertex === null ? undefined : Math.min(...panelsAt(mesh, vertex));
  return panel !== undefined && Number.isFinite(panel) ? `${panel}:${vertex}` : "";
}

const UP: Point = [0, 0, 1];

/** Below this share of their lengths two directions are one. */
const PARALLEL = 1e-6;

/** A direction at right angles to both; null where they are parallel. */
function normalOf(a: Point, b: Point): Point | null {
  const normal = cross(a, b);
  const length = Math.hypot(...normal);
  if (!(length > PARALLEL * Math.hypot(...a) * Math.hypot(...b))) return null;
  return [normal[0] / length, normal[1] / length, normal[2] / length];
}

/** A plane through the selected points as far as three say it, upright through two, level through one. */
function planeThrough(points: readonly Point[]): readonly [Point, Point] | null {
  const [first, ...rest] = points;
  const last = rest.at(-1);
  if (!first) return null;
  if (!last) return [UP, first];
  const along = minus(last, first);
  const beside = rest.map((point) => normalOf(along, minus(point, first))).find((n) => n !== null);
  const normal = beside ?? normalOf(along, UP);
  return normal && [normal, first];
}

const figure = (x: number): string => String(Number(x.toPrecision(12)) + 0);

/** A cut through the selected points of the mesh before the edit; else where the view is cut open. */
function trim(page: Page): string {
  const plane = planeThrough(page.selection.value.map((v) => basePoint(page, v)));
  if (plane) {
    const [normal, through] = plane;
    const distance = normal.reduce((sum, x, k) => sum + x * (through[k] ?? 0), 0);
    return [...normal, distance].map(figure).join();
  }
  const shown = sectionPlane(page).value;
  if (!shown) return "";
  const sign = shown.flipped ? -1 : 1;
  return [0, 1, 2, 3]
    .map((k) => figure(k === 3 ? sign * shown.at : k === shown.axis ? sign : 0))
    .join();
}

/** @param kind of the cut whose numbers are wanted */
export function fromSelection(page: Page, kind: CutKind): string {
  const mesh = page.displayMesh.value;
  if (!mesh) return "";
  if (kind === "split") return split(page, mesh);
  if (kind === "strip") return strip(page, mesh);
  if (kind === "corner") return corner(page, mesh);
  return kind === "refine" ? selectedMembers(page, "panels").join() : trim(page);
}

/** The plane from its other side; what is no plane stays. */
export function otherSide(plane: string): string {
  const numbers = plane.split(",").map(Number);
  return numbers.some(Number.isNaN) ? plane : numbers.map((x) => figure(-x)).join();
}
