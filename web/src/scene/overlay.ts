// SPDX-License-Identifier: MIT
// What is drawn over the canvas at constant size: points, the first visit's sentence, the selected
// panel's figure, and the line around what is being selected.
import { cleanView } from "../state/clean-view.ts";
import { isHidden } from "../state/hidden-panels.ts";
import type { Page } from "../state/page.ts";
import { sideOf } from "./label-side.ts";
import { type Marker, Markers } from "./markers.ts";
import type { Outline } from "./outline.ts";
import { type Place, project, type View } from "./picking.ts";
import { type Pull, PullLines } from "./pull-lines.ts";

export interface OverlayParts {
  readonly markers: HTMLElement;
  /** From where handles were to where they are pulled. */
  readonly pulls: HTMLElement;
  /** The first visit's sentence; placed beside its point. */
  readonly hint: HTMLElement;
  /** The selected panel's figure; placed beside it. */
  readonly figure: HTMLElement;
  /** The figure of the point looked at; placed below it. */
  readonly point: HTMLElement;
  /** Around what is being selected; holds a polygon. */
  readonly area: HTMLElement;
}

/** Pixels: the drag tools at the top of the view and three lines of figures under them. */
const ROOM = 124;

function markersFor(page: Page): Marker[] {
  if (cleanView(page).value) return [];
  const hovered = page.visited.value;
  const chosen = new Set(page.selection.value);
  const markers: Marker[] = page.handles.value.map(({ vertex, pinned }) => ({
    vertex,
    kind: pinned ? "pin" : "handle",
    selected: chosen.has(vertex),
  }));
  const known = new Set(markers.map((marker) => marker.vertex));
  for (const vertex of page.images.value) {
    if (!known.has(vertex)) markers.push({ vertex, kind: "image", selected: chosen.has(vertex) });
    known.add(vertex);
  }
  for (const vertex of page.supported.value) {
    if (!known.has(vertex)) markers.push({ vertex, kind: "support", selected: chosen.has(vertex) });
    known.add(vertex);
  }
  for (const vertex of chosen) {
    if (!known.has(vertex)) markers.push({ vertex, kind: "point", selected: true });
  }
  if (hovered !== null && !known.has(hovered) && !chosen.has(hovered)) {
    markers.push({ vertex: hovered, kind: "hover", selected: false });
  }
  if (page.hintVertex.value !== null && page.selected.value === null) {
    markers.push({ vertex: page.hintVertex.value, kind: "first", selected: false });
  }
  return markers.filter(({ vertex }) => !isHidden(page, vertex));
}

export class Overlay {
  readonly #page: Page;
  readonly #parts: OverlayParts;
  readonly #markers: Markers;
  readonly #pulls: PullLines;
  /** Corners of the selected panel. */
  #panel: Float32Array | null = null;

  constructor(page: Page, parts: OverlayParts) {
    this.#page = page;
    this.#parts = parts;
    this.#markers = new Markers(parts.markers);
    this.#pulls = new PullLines(parts.pulls);
  }

  update(): void {
    this.#markers.set(markersFor(this.#page));
  }

  setPulls(pulls: readonly Pull[]): void {
    this.#pulls.set(pulls);
  }

  showPulls(on: boolean): void {
    this.#parts.pulls.hidden = !on;
  }

  setPanel(corners: Float32Array | null): void {
    this.#panel = corners;
  }

  /** Puts everything where the camera sees it; display coordinates of the design and its base. */
  place(points: Float32Array, base: Float32Array, view: View): void {
    this.#markers.place(points, view);
    this.#pulls.place(base, view);
    const { hint, point } = this.#parts;
    const [first, clean] = [this.#page.hintVertex.value, cleanView(this.#page).value];
    const unsaid = first === null || this.#page.selected.value !== null || clean;
    const at = unsaid ? null : project(points, first, view);
    putAt(hint, at);
    hint.dataset.side = at !== null && at.y < ROOM ? "below" : "above";
    this.#placePoint(point, points, view);
    this.#placeFigure(view);
  }

  /** Puts the figure above the panel, or below it where the drag tools would cover the figure. */
  #placeFigure(view: View): void {
    const { figure } = this.#parts;
    const seen = this.#panel && spanOf(this.#panel, view);
    const below = seen !== null && seen.top < ROOM;
    putAt(figure, seen && { x: seen.x, y: below ? seen.bottom : seen.top });
    figure.dataset.side = below ? "below" : "above";
  }

  #placePoint(element: HTMLElement, points: Float32Array, view: View): void {
    const leading = this.#page.pull.value?.vertex ?? null;
    const hovered = (leading ?? this.#page.visited.value) !== null;
    // Of several that are chosen it would only be in the way of the others.
    const seen =
      leading ??
      this.#page.visited.value ??
      (this.#page.selection.value.length === 1 ? this.#page.selected.value : null);
    const place = seen === null ? null : project(points, seen, view);
    if (seen === null || !place || cleanView(this.#page).value) {
      putAt(element, null);
      return;
    }
    const side = sideOf(place, this.#markers.places(points, view, seen), view);
    // Above or below a chosen point the note would hide what follows it, beside a selected panel the panel.
    const aside = side === "left" || side === "right";
    putAt(element, hovered || (aside && this.#panel === null) ? place : null);
    element.dataset.side = side;
  }

  drawOutline(outline: Outline | null): void {
    const { area } = this.#parts;
    area.hidden = outline === null;
    if (!outline) return;
    const points = outline.map(({ x, y }) => `${x},${y}`).join(" ");
    area.querySelector("polygon")?.setAttribute("points", points);
  }
}

/** Hides an element, or puts it somewhere, in pixels of the view. */
export function putAt(element: HTMLElement, at: Place | null): void {
  element.hidden = at === null;
  if (at) element.style.transform = `translate(${at.x.toFixed(0)}px, ${at.y.toFixed(0)}px)`;
}

/** The middle of the panel's corners, and the highest and lowest of them on screen. */
function spanOf(
  corners: Float32Array,
  view: View,
): { x: number; top: number; bottom: number } | null {
  const count = corners.length / 3;
  let [x, top, bottom] = [0, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let k = 0; k < count; ++k) {
    const at = project(corners, k, view);
    if (!at) return null;
    x += at.x / count;
    top = Math.min(top, at.y);
    bottom = Math.max(bottom, at.y);
  }
  return { x, top, bottom };
}
