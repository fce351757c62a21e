// SPDX-License-Identifier: MIT
// The triangles that panels are drawn as: cut anew where corners move, empty where a panel is hidden.
import type { BufferAttribute } from "three";
import type { DisplayMesh } from "../mesh/display-mesh.ts";
import { row, type Topology } from "../mesh/topology.ts";
import { firstTriangle, panelAt, triangulatePanel } from "../mesh/triangulation.ts";
import { DirtyRange } from "./dirty-range.ts";

export class PanelCuts {
  /** A panel's own are always at the same place in it. */
  readonly triangles: Uint32Array;
  readonly #offsets: Int32Array;
  readonly #topology: Topology;
  readonly #dirty = new DirtyRange();
  #hidden: ReadonlySet<number> = new Set();

  constructor({ triangles, offsets, topology }: DisplayMesh) {
    this.triangles = triangles.slice();
    this.#offsets = offsets;
    this.#topology = topology;
  }

  get hidden(): ReadonlySet<number> {
    return this.#hidden;
  }

  /** `corners`: display coordinates of every place in the face list. */
  hide(panels: ReadonlySet<number>, corners: Float32Array): void {
    const changed = new Set([...this.#hidden, ...panels]);
    this.#hidden = panels;
    for (const panel of changed) this.#cut(panel, corners);
  }

  /** A panel that was convex may have become concave, and the other way round. */
  cutAt(vertices: Iterable<number>, corners: Float32Array): void {
    const touched = new Set<number>();
    for (const v of vertices) {
      for (const corner of row(this.#topology.corners, v)) {
        touched.add(panelAt(this.#offsets, corner));
      }
    }
    for (const panel of touched) {
      const count = (this.#offsets[panel + 1] ?? 0) - (this.#offsets[panel] ?? 0);
      if (count > 3 && !this.#hidden.has(panel)) this.#cut(panel, corners);
    }
  }

  #cut(panel: number, corners: Float32Array): void {
    const [begin, end] = [this.#offsets[panel] ?? 0, this.#offsets[panel + 1] ?? 0];
    const first = firstTriangle(this.#offsets, panel);
    const last = first + end - begin - 3;
    if (last < first) return;
    if (this.#hidden.has(panel)) this.triangles.fill(begin, 3 * first, 3 * last + 3);
    else triangulatePanel(corners, begin, end, this.triangles, first);
    this.#dirty.add(first);
    this.#dirty.add(last);
  }

  /** Marks what changed for upload. */
  flush(index: BufferAttribute): void {
    this.#dirty.flush(index, 3);
  }
}
