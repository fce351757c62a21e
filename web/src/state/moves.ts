// SPDX-License-Identifier: MIT
// How far every point is from its base while it moves, and how much of that is off the old surface
// and along it, from the changes that are shown.

import { type Signal, signal } from "@preact/signals";
import { type Motion, OldSurface } from "../mesh/old-surface.ts";
import { add, minus, type Vector } from "../mesh/vector.ts";
import type { OpenedMesh, Shape } from "../solver/protocol.ts";
import { onChanges } from "./connection.ts";
import { kept, type Page } from "./page.ts";
import { motionEnd } from "./ramp-ends.ts";

const STILL: Vector = [0, 0, 0];

export class Moves {
  readonly mesh: OpenedMesh;
  /** By vertex, model units; points at rest are not there. */
  readonly lengths = new Map<number, number>();
  readonly #ways = new Map<number, Vector>();
  readonly #oldSurface: OldSurface;
  /** Of the points that changed since the last mark, as they were then. */
  #marked = new Map<number, Vector>();
  /** Of all that moved; null until someone asks. */
  #motions: ReadonlyMap<number, Motion> | null = null;

  constructor(mesh: OpenedMesh, { moved, positions }: Shape) {
    this.mesh = mesh;
    this.#oldSurface = new OldSurface(mesh.positions, mesh);
    moved.forEach((v, k) => {
      const at = (c: number): number => (positions[3 * k + c] ?? 0) - this.#base(v, c);
      this.#note(v, [at(0), at(1), at(2)]);
    });
  }

  /** `changes`: vertex, x, y, z in display coordinates, as the view gets them. */
  apply(changes: Float32Array): void {
    const { display, report } = this.mesh;
    this.#motions = null;
    for (let k = 0; k + 3 < changes.length; k += 4) {
      const v = changes[k] ?? 0;
      const gap = (c: number): number =>
        ((changes[k + 1 + c] ?? 0) - (display[3 * v + c] ?? 0)) / report.scale;
      this.#note(v, [gap(0), gap(1), gap(2)]);
    }
  }

  /** Motions by vertex, model units. */
  get motions(): ReadonlyMap<number, Motion> {
    this.#motions ??= new Map(Array.from(this.#ways.keys(), (v) => [v, this.motionOf(v)] as const));
    return this.#motions;
  }

  motionOf(vertex: number): Motion {
    const place: Vector = [this.#base(vertex, 0), this.#base(vertex, 1), this.#base(vertex, 2)];
    return this.#oldSurface.motion(vertex, add(place, this.#ways.get(vertex) ?? [0, 0, 0]));
  }

  /** From here on `farthest` counts. */
  mark(): void {
    this.#marked = new Map();
  }

  /** How far points are from where they were at the last mark, at most; model units. */
  get farthest(): number {
    return Array.from(this.#marked, ([v, before]) => minus(this.#way(v), before)).reduce(
      (most, apart) => Math.max(most, Math.hypot(...apart)),
      0,
    );
  }

  /** The value at the ends of the legend, model units; 0 where nothing moved. */
  endOf(kind: "shape" | "slide"): number {
    const longest = [...this.lengths.values()].reduce((most, one) => Math.max(most, one), 0);
    return motionEnd(
      Array.from(this.motions.values(), (motion) => motion[kind]),
      longest,
    );
  }

  #base(vertex: number, axis: number): number {
    return this.mesh.positions[3 * vertex + axis] ?? 0;
  }

  #way(vertex: number): Vector {
    return this.#ways.get(vertex) ?? STILL;
  }

  #note(vertex: number, way: Vector): void {
    if (!this.#marked.has(vertex)) this.#marked.set(vertex, this.#way(vertex));
    const length = Math.hypot(...way);
    if (length > 0) {
      this.lengths.set(vertex, length);
      this.#ways.set(vertex, way);
    } else {
      this.lengths.delete(vertex);
      this.#ways.delete(vertex);
    }
  }
}

interface Own {
  current: Moves | null;
  /** Counts the changes that were shown: the figures may be those of before, as where a preview ends. */
  readonly shown: Signal<number>;
}

const own = kept((page): Own => {
  const mine: Own = { current: null, shown: signal(0) };
  onChanges(page, (changes) => {
    mine.current?.apply(changes);
    mine.shown.value += 1;
  });
  return mine;
});

/** The moves of what is shown on `mesh`; `shape` is the design that they are counted from at first. */
export function movesOn(page: Page, mesh: OpenedMesh, shape: Shape): Moves {
  const mine = own(page);
  const moves = mine.current?.mesh === mesh ? mine.current : new Moves(mesh, shape);
  mine.current = moves;
  return moves;
}

/** The moves of what is in view; null without a mesh. */
export function movesShown(page: Page): Moves | null {
  const [opened, design] = [page.mesh.value, page.draft.value];
  own(page).shown.value;
  return opened && design && movesOn(page, opened, design.shape);
}
