// SPDX-License-Identifier: MIT
// What the pointer chooses in the view: points, panels, lines of the mesh, and areas.

import type { Ray } from "three";
import { row } from "../mesh/topology.ts";
import { handleOf } from "../state/editing.ts";
import { fetchPart } from "../state/later.ts";
import {
  deselect,
  selectAlso,
  selectOnly,
  selectThese,
  toggleSelected,
  visit,
} from "../state/selection.ts";
import { sensibleVertex } from "../state/sensible-vertex.ts";
import { verticesIn } from "./area-picking.ts";
import type { Gizmo } from "./gizmo.ts";
import type { Outline } from "./outline.ts";
import { type Place, pickVertex, project, type View } from "./picking.ts";
import type { Click, Hold } from "./pointer.ts";
import type { Shell } from "./shell.ts";
import type { Sight } from "./sight.ts";

/** The vertex across the edge in the picture that points most nearly in a direction on screen. */
function neighbourTowards(
  shell: Shell,
  vertex: number,
  right: number,
  down: number,
  view: View,
): number {
  const from = project(shell.current, vertex, view);
  if (!from) return vertex;
  const { edges, edgeEnds } = shell.drawn;
  let best = vertex;
  let closest = 0.3;
  for (const end of row(edgeEnds, vertex)) {
    const other = edges[end ^ 1] ?? vertex;
    const to = project(shell.current, other, view);
    if (!to) continue;
    const [dx, dy] = [to.x - from.x, to.y - from.y];
    const cosine = (dx * right + dy * down) / (Math.hypot(dx, dy) || 1);
    if (cosine > closest) {
      closest = cosine;
      best = other;
    }
  }
  return best;
}

/** Pixels about a selected point that are its own, even where arrows begin. */
const CORE = 9;

export class PointerChoice {
  readonly #sight: Sight;
  readonly #gizmo: Gizmo;
  /** Clicks so far: what an earlier one would choose comes too late. */
  #clicks = 0;
  #choosing = false;

  constructor(sight: Sight, gizmo: Gizmo) {
    this.#sight = sight;
    this.#gizmo = gizmo;
  }

  /** Whether a panel is being chosen here, so that it is in view already. */
  get choosing(): boolean {
    return this.#choosing;
  }

  /** The structure, once it can be used. */
  #usable(): Shell | null {
    return this.#sight.page.ready.value ? this.#sight.shell : null;
  }

  find(x: number, y: number, coarse: boolean): Hold | null {
    const [shell, { page }] = [this.#usable(), this.#sight];
    if (!shell) return null;
    const view = this.#sight.view();
    const marked = (vertex: number): boolean => {
      const at = project(shell.current, vertex, view);
      return at !== null && Math.hypot(at.x - x, at.y - y) < CORE;
    };
    const own = page.selection.value.findLast(marked);
    if (own !== undefined) return { vertex: own, arrow: null };
    const arrow = this.#gizmo.hover(x, y, view.width, view.height);
    const leader = arrow && page.selection.value.findLast((v) => !handleOf(page, v)?.pinned);
    if (arrow && leader !== undefined && leader !== null) return { vertex: leader, arrow };
    const vertex = pickVertex(shell, { x, y }, coarse, view);
    return vertex === null ? null : { vertex, arrow: null };
  }

  /** False if the pointer rests where it did. */
  hover(hold: Hold | null): boolean {
    const { page, canvas } = this.#sight;
    const drawing = page.areaTool.value !== null || page.cutting.value;
    canvas.style.cursor = hold ? "grab" : drawing ? "crosshair" : "";
    const vertex = hold && !hold.arrow ? hold.vertex : null;
    if (vertex === page.visited.value) return false;
    visit(page, vertex);
    return true;
  }

  click(x: number, y: number, hold: Hold | null, { also, coarse }: Click): void {
    this.#clicks += 1;
    if (hold?.arrow) return;
    if (hold && also) toggleSelected(this.#sight.page, hold.vertex);
    else if (hold) selectOnly(this.#sight.page, hold.vertex);
    else if (!also) void this.#panel({ x, y }, coarse);
  }

  /** The panel that a click means becomes the selected one; beside the model nothing is selected. */
  async #panel(place: Place, coarse: boolean): Promise<void> {
    const { page, shell } = this.#sight;
    deselect(page);
    const click = this.#clicks;
    const part = await fetchPart(page, () => import("./panel-picking.ts"));
    if (!shell || !part || shell !== this.#sight.shell || click !== this.#clicks) return;
    const rayThrough = (at: Place): Ray => this.#sight.rayThrough(at);
    this.#choosing = true;
    page.selectedPanel.value = part.pickPanel(shell, place, coarse, this.#sight.view(), rayThrough);
    this.#choosing = false;
  }

  /** The line of the mesh, or the strip, that a double click on an edge means. */
  async line(place: Place, { also, ring }: { also: boolean; ring: boolean }): Promise<void> {
    const [shell, { page }] = [this.#usable(), this.#sight];
    if (!shell) return;
    this.#clicks += 1;
    const part = await fetchPart(page, () => import("./line-picking.ts"));
    if (shell !== this.#sight.shell) return;
    const line = part?.pickLine(shell, place, ring, this.#sight.view());
    if (!line) return;
    if (also) selectAlso(page, line);
    else selectThese(page, line);
    page.selectedPanel.value = null;
  }

  /** The points that a line drawn on screen goes round, those behind the surface too. */
  area(outline: Outline, also: boolean): void {
    const [shell, { page }] = [this.#usable(), this.#sight];
    page.areaTool.value = null;
    if (!shell) return;
    const inside = verticesIn(outline, shell, this.#sight.view());
    if (also) selectAlso(page, inside);
    else selectThese(page, inside);
  }

  /** Goes to the nearest point in a direction on screen; `also` keeps what was chosen. */
  step(right: number, down: number, also: boolean): void {
    const [shell, { page }] = [this.#usable(), this.#sight];
    if (!shell) return;
    const from = page.selected.value;
    const next =
      from === null
        ? sensibleVertex(shell.base, shell.topology.boundary, [], (v) => this.#sight.sees(v))
        : neighbourTowards(shell, from, right, down, this.#sight.view());
    if (next === null) return;
    if (also) selectAlso(page, [next]);
    else selectOnly(page, next);
  }
}
