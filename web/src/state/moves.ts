// SPDX-License-Identifier: MIT
// How far every point is from its base while it moves, from the changes that are shown.

import type { OpenedMesh, Shape } from "../solver/protocol.ts";
import { onChanges } from "./connection.ts";
import { kept, type Page } from "./page.ts";

export class Moves {
  readonly mesh: OpenedMesh;
  /** By vertex, model units; points at rest are not there. */
  readonly lengths = new Map<number, number>();

  constructor(mesh: OpenedMesh, { moved, positions }: Shape) {
    this.mesh = mesh;
    moved.forEach((v, k) => {
      const at = (c: number): number => positions[3 * k + c] ?? 0;
      this.#note(v, Math.hypot(...[0, 1, 2].map((c) => at(c) - (mesh.positions[3 * v + c] ?? 0))));
    });
  }

  /** `changes`: vertex, x, y, z in display coordinates, as the view gets them. */
  apply(changes: Float32Array): void {
    const { display, report } = this.mesh;
    for (let k = 0; k + 3 < changes.length; k += 4) {
      const v = changes[k] ?? 0;
      const gap = (c: number): number => (changes[k + 1 + c] ?? 0) - (display[3 * v + c] ?? 0);
      this.#note(v, Math.hypot(gap(0), gap(1), gap(2)) / report.scale);
    }
  }

  #note(vertex: number, length: number): void {
    if (length > 0) this.lengths.set(vertex, length);
    else this.lengths.delete(vertex);
  }
}

interface Own {
  current: Moves | null;
}

const own = kept((page): Own => {
  const mine: Own = { current: null };
  onChanges(page, (changes) => mine.current?.apply(changes));
  return mine;
});

/** The moves of what is shown on `mesh`; `shape` is the design that they are counted from at first. */
export function movesOn(page: Page, mesh: OpenedMesh, shape: Shape): Moves {
  const mine = own(page);
  const moves = mine.current?.mesh === mesh ? mine.current : new Moves(mesh, shape);
  mine.current = moves;
  return moves;
}
