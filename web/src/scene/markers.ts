// SPDX-License-Identifier: MIT
// Handles, pins and the hovered point, drawn over the canvas at constant size.
import { ElementPool } from "./element-pool.ts";
import { type Place, project, type View } from "./picking.ts";

/** More marks than this would hide the model. */
const LIMIT = 400;

/** More marks of a kind than this are small: together they tell a region, and are not one by one. */
export const MANY = 24;

type Kind = "handle" | "pin" | "image" | "support" | "point" | "hover" | "first";

/** The kinds that shrink where they are dense. */
const DENSE: readonly Kind[] = ["handle", "pin", "image"];

export interface Marker {
  readonly vertex: number;
  readonly kind: Kind;
  readonly selected: boolean;
}

export class Markers {
  readonly #elements: ElementPool;
  #markers: readonly Marker[] = [];

  constructor(layer: HTMLElement) {
    this.#elements = new ElementPool(() => layer.appendChild(document.createElement("span")));
  }

  set(markers: readonly Marker[]): void {
    this.#markers = markers.slice(0, LIMIT);
    this.#elements.resize(this.#markers.length);
    const count = (of: Kind): number => this.#markers.filter(({ kind }) => kind === of).length;
    const small = DENSE.filter((kind) => count(kind) > MANY);
    this.#markers.forEach(({ kind, selected }, k) => {
      const element = this.#elements.at(k);
      if (!element) return;
      element.className = `marker ${kind}${selected ? " selected" : ""}${small.includes(kind) ? " small" : ""}`;
    });
  }

  /** Where the marks of other points than `vertex` are on screen. */
  places(points: Float32Array, view: View, vertex: number): Place[] {
    const others = this.#markers.filter((marker) => marker.vertex !== vertex);
    return others.flatMap((marker) => project(points, marker.vertex, view) ?? []);
  }

  place(points: Float32Array, view: View): void {
    this.#markers.forEach((marker, k) => {
      const element = this.#elements.at(k);
      const at = project(points, marker.vertex, view);
      if (!element) return;
      element.hidden = at === null;
      if (at) element.style.transform = `translate(${at.x.toFixed(1)}px, ${at.y.toFixed(1)}px)`;
    });
  }
}
