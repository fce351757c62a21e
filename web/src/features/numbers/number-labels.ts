// SPDX-License-Identifier: MIT
// The numbers of panels and points where there is room for them: those in sight, chosen anew whenever
// the view rests.
import { Vector3 } from "three";
import { ElementPool } from "../../scene/element-pool.ts";
import { type Place, project, type View } from "../../scene/picking.ts";
import type { Shell } from "../../scene/shell.ts";
import { hiddenPanels } from "../../state/hidden-panels.ts";
import type { Page } from "../../state/page.ts";
import { Cover } from "./cover.ts";

/** Labels at most: more would hide the model. */
const MOST = 300;
/** Pixels that a panel, or the edges at a point, must span. */
const ROOM = 22;
/** Pixels of a digit, of a line, and from a point down to its number. */
const [DIGIT, LINE, DOWN] = [7, 12, 10];
/** The share of its size by which something must be in front of a panel or point to hide it. */
const IN_FRONT = 0.3;

export interface Numbered {
  readonly panels: boolean;
  readonly points: boolean;
}

interface Label {
  readonly kind: "panel" | "point";
  readonly number: number;
}

/** Where it would stand, pixels, how deep what it names is, and how far from the middle of the view. */
interface Candidate extends Label, Place {
  readonly at: Place;
  readonly depth: number;
  readonly away: number;
}

/** Whether a place, display coordinates, is cut away; null: nothing is. */
export type Cut = ((at: Vector3) => boolean) | null;

/** The candidates, in their order, that are in sight and touch none before. */
function apart(candidates: readonly Candidate[], cover: Cover): Candidate[] {
  const kept: Candidate[] = [];
  const width = ({ number }: Label): number => DIGIT * String(number).length;
  for (const one of candidates) {
    if (kept.length === MOST) break;
    const touches = kept.some(
      (other) =>
        Math.abs(other.y - one.y) < LINE &&
        2 * Math.abs(other.x - one.x) < width(other) + width(one),
    );
    if (!touches && !cover.hides(one.at, one.depth)) kept.push(one);
  }
  return kept;
}

const middle = new Vector3();
const corner = new Vector3();

/** Display coordinates, and how far the corners are from there on average. */
function panelAt({ current, offsets, vertices }: Shell, panel: number): number {
  const all = vertices.subarray(offsets[panel] ?? 0, offsets[panel + 1] ?? 0);
  middle.set(0, 0, 0);
  for (const v of all) middle.add(corner.fromArray(current, 3 * v));
  middle.divideScalar(all.length);
  let size = 0;
  for (const v of all) size += corner.fromArray(current, 3 * v).distanceTo(middle);
  return size / all.length;
}

export class NumberLabels {
  readonly #page: Page;
  readonly #pool: ElementPool;
  readonly #layer: HTMLElement;
  #labels: readonly Label[] = [];

  constructor(page: Page, canvas: HTMLCanvasElement) {
    this.#page = page;
    this.#layer = document.createElement("div");
    this.#layer.className = "markers numbers";
    this.#layer.ariaHidden = "true";
    canvas.after(this.#layer);
    this.#pool = new ElementPool(() => this.#layer.appendChild(document.createElement("span")));
  }

  /** Which are shown; those nearest to the middle of the view if there are too many. */
  choose(shell: Shell, view: View, of: Numbered, cut: Cut): void {
    const found = this.#candidates(shell, view, of, cut);
    found.sort((a, b) => a.away - b.away);
    const isCut = (k: number): boolean => cut?.(corner.fromArray(shell.corners, 3 * k)) ?? false;
    this.#labels = found.length > 0 ? apart(found, new Cover(shell, view, isCut)) : [];
    this.#pool.resize(this.#labels.length);
    this.#labels.forEach(({ kind, number }, k) => {
      const element = this.#pool.at(k);
      if (!element) return;
      element.className = kind;
      element.textContent = String(number);
    });
    this.place(shell, view);
  }

  place(shell: Shell, view: View): void {
    this.#labels.forEach(({ kind, number }, k) => {
      if (kind === "panel") panelAt(shell, number);
      else middle.fromArray(shell.current, 3 * number);
      const at = project(Float32Array.from(middle.toArray()), 0, view);
      const element = this.#pool.at(k);
      if (!element) return;
      element.hidden = at === null;
      if (at) element.style.transform = `translate(${at.x.toFixed(1)}px, ${at.y.toFixed(1)}px)`;
    });
  }

  dispose(): void {
    this.#layer.remove();
  }

  /** Panels and points that are large enough and in view, whether or not something is in front. */
  #candidates(shell: Shell, view: View, { panels, points }: Numbered, cut: Cut): Candidate[] {
    const found: Candidate[] = [];
    const add = (label: Label, size: number): void => {
      const at = cut?.(middle) ? null : standing(size, view);
      if (!at) return;
      const away = Math.hypot(at.x - view.width / 2, at.y - view.height / 2);
      const down = label.kind === "point" ? DOWN : 0;
      found.push({ ...label, x: at.x, y: at.y + down, at, depth: at.depth, away });
    };
    const hidden = hiddenPanels(this.#page).peek();
    for (let f = 0; panels && f + 1 < shell.offsets.length; ++f) {
      if (!hidden.has(f)) add({ kind: "panel", number: f }, panelAt(shell, f));
    }
    for (let v = 0; points && v < shell.current.length / 3; ++v) {
      if (shell.isShown(v)) add({ kind: "point", number: v }, pointAt(shell, v));
    }
    return found;
  }
}

const [eye, sideways] = [new Vector3(), new Vector3()];
const ends = new Float32Array(6);

/** Where what is at `middle` and so large is on screen, and a little in front of it how deep; null
 * where it is too small or out of view. */
function standing(size: number, view: View): (Place & { readonly depth: number }) | null {
  view.camera.getWorldPosition(eye).sub(middle);
  const front = corner.copy(middle).addScaledVector(eye, (IN_FRONT * size) / eye.length());
  sideways.setFromMatrixColumn(view.camera.matrixWorld, 0);
  front.toArray(ends, 0);
  front.addScaledVector(sideways, size).toArray(ends, 3);
  const [at, end] = [project(ends, 0, view), project(ends, 1, view)];
  if (!at || !end || 2 * Math.hypot(end.x - at.x, end.y - at.y) < ROOM) return null;
  const inside = at.x >= 0 && at.y >= 0 && at.x <= view.width && at.y <= view.height;
  return inside ? at : null;
}

/** Leaves where a point is in `middle`; half the mean length of its edges. */
function pointAt({ current, topology }: Shell, vertex: number): number {
  middle.fromArray(current, 3 * vertex);
  const { edges, edgeEnds } = topology;
  const [from, to] = [edgeEnds.offsets[vertex] ?? 0, edgeEnds.offsets[vertex + 1] ?? 0];
  let sum = 0;
  for (let k = from; k < to; ++k) {
    const other = edges[(edgeEnds.values[k] ?? 0) ^ 1] ?? vertex;
    sum += corner.fromArray(current, 3 * other).distanceTo(middle);
  }
  return sum / (2 * Math.max(1, to - from));
}
