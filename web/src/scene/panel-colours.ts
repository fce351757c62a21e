// SPDX-License-Identifier: MIT
// What the colours of the panels mean: how far points moved, how sharply the edit bends, how far
// panels are out of flat, whether they can be made, or must be made again.
import { BufferAttribute, DynamicDrawUsage } from "three";
import { GROUP_COLOURS } from "../design/groups.ts";
import type { DisplayMesh } from "../mesh/display-mesh.ts";
import { row } from "../mesh/topology.ts";
import { PER_PANEL } from "../solver/protocol.ts";
import type { ColourBy } from "../state/page-state.ts";
import { TROUBLES } from "../state/panel-trouble.ts";
import {
  CONJUGACY_END,
  defectEnd,
  foldEnd,
  largest,
  planarityEnd,
  planarityShare,
} from "../state/ramp-ends.ts";
import { DirtyRange } from "./dirty-range.ts";
import type { Palette } from "./palette.ts";
import { makeRamp, type Ramp, remakePlace, writeRamp } from "./ramp.ts";

/** Where a panel's PanelChange is among its figures of health. */
const CHANGE = 3;

/** What is measured of points. */
const OF_POINTS: readonly ColourBy[] = ["fairness", "conical", "mobility"];

/** What is seen from where points are. */
const OF_MOVES: readonly ColourBy[] = ["displacement", "shape", "slide"];

export class PanelColours {
  readonly attribute: BufferAttribute;
  readonly #mesh: DisplayMesh;
  readonly #colour: Float32Array;
  readonly #dirty = new DirtyRange();
  #ramp: Ramp = [];
  #loweredRamp: Ramp = [];
  #panelRamp: Ramp = [];
  #groupRamp: Ramp = [];
  #kind: ColourBy = "displacement";
  #figures: Float32Array | null = null;

  constructor(mesh: DisplayMesh) {
    this.#mesh = mesh;
    this.#colour = new Float32Array(3 * mesh.vertices.length);
    this.attribute = new BufferAttribute(this.#colour, 3).setUsage(DynamicDrawUsage);
  }

  setPalette(palette: Palette): void {
    this.#ramp = makeRamp(palette.displacement);
    this.#loweredRamp = makeRamp(palette.lowered);
    this.#panelRamp = makeRamp(palette.planarity);
    this.#groupRamp = makeRamp([palette.planarity[0] ?? "", ...GROUP_COLOURS]);
  }

  /**
   * `figures`: of points for fairness, mobility and conical nodes, of panels otherwise; null for how the
   * points moved.
   */
  choose(kind: ColourBy, figures: Float32Array | null): void {
    this.#kind = kind;
    this.#figures = figures;
  }

  /** Gives every panel its colour; points get theirs from `paintVertex`. */
  paintAll(): void {
    if (this.#figures && OF_POINTS.includes(this.#kind)) this.#paintPoints(this.#figures);
    else if (this.#figures) this.#paintPanels(this.#figures);
    else this.#paintNeutral();
    this.#dirty.addAll(this.#mesh.vertices.length);
  }

  /** `share` of the largest displacement, slide or change of shape; below 0: inside of the old surface. */
  paintVertex(vertex: number, share: number): void {
    if (this.#figures) return;
    const t = OF_MOVES.includes(this.#kind) ? share : 0;
    const ramp = t < 0 ? this.#loweredRamp : this.#ramp;
    for (const corner of row(this.#mesh.topology.corners, vertex)) {
      writeRamp(ramp, Math.abs(t), this.#colour, 3 * corner);
      this.#dirty.add(corner);
    }
  }

  upload(): void {
    this.#dirty.flush(this.attribute, 3);
  }

  #paintNeutral(): void {
    writeRamp(this.#ramp, 0, this.#colour, 0);
    // What is painted already, again behind itself: a million panels in a hundredth of a second.
    for (let done = 3; done < this.#colour.length; done *= 2)
      this.#colour.copyWithin(done, 0, done);
  }

  #paintPoints(values: Float32Array): void {
    const end = this.#kind === "conical" ? defectEnd(values) : largest(values);
    const ramp = this.#kind === "mobility" ? this.#ramp : this.#panelRamp;
    values.forEach((value, vertex) => {
      const t = end > 0 ? value / end : 0;
      for (const corner of row(this.#mesh.topology.corners, vertex)) {
        writeRamp(ramp, t, this.#colour, 3 * corner);
      }
    });
  }

  /**
   * A panel's place on the ramp. Flatness: neutral where flat, then logarithmic up to planarityEnd().
   * Folds, a kind's defects and conjugacy: in proportion, up to foldEnd(), defectEnd() or CONJUGACY_END. Health: by the
   * class, convex neutral, self-crossing at its end. Groups and types: neutral, then one colour
   * after the other. What must be made again: see remakePlace().
   */
  #placeOf(figures: Float32Array): (panel: number) => number {
    if (this.#kind === "groups" || this.#kind === "types")
      return (f) => (figures[f] ?? 0) / GROUP_COLOURS.length;
    if (this.#kind === "health") return (f) => (figures[f] ?? 0) / (TROUBLES.length - 1);
    if (this.#kind === "remake")
      return (f) => remakePlace(figures[PER_PANEL.health * f + CHANGE] ?? 0);
    if (this.#kind === "fold" || this.#kind === "circular") {
      const end = this.#kind === "fold" ? foldEnd(figures) : defectEnd(figures);
      return (f) => (figures[f] ?? 0) / end;
    }
    if (this.#kind === "conjugacy") return (f) => (figures[f] ?? 0) / CONJUGACY_END;
    const end = planarityEnd(figures);
    return (f) => planarityShare(figures[PER_PANEL.figures * f + 2] ?? 0, end);
  }

  #paintPanels(figures: Float32Array): void {
    const { offsets } = this.#mesh;
    const place = this.#placeOf(figures);
    const isNamed = this.#kind === "groups" || this.#kind === "types";
    const ramp = isNamed ? this.#groupRamp : this.#panelRamp;
    for (let f = 0; f + 1 < offsets.length; ++f) {
      const t = place(f);
      for (let c = offsets[f] ?? 0; c < (offsets[f + 1] ?? 0); ++c) {
        writeRamp(ramp, t, this.#colour, 3 * c);
      }
    }
  }
}
