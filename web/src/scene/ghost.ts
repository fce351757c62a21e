// SPDX-License-Identifier: MIT
// Where the structure was: the base's edges about the points that moved. Each is one whole line,
// a little fainter where the surface hides it.
import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  GreaterDepth,
  Group,
  LessEqualDepth,
  LineBasicMaterial,
  LineSegments,
} from "three";
import { displaySphere } from "./framing.ts";

/** How the lines are drawn before the surface and behind it. */
const PASSES = [
  { depthFunc: LessEqualDepth, opacity: 0.34 },
  { depthFunc: GreaterDepth, opacity: 0.2 },
] as const;

export class Ghost {
  readonly object = new Group();
  readonly #geometry = new BufferGeometry();
  readonly #materials: readonly LineBasicMaterial[];

  /** `base`: display coordinates of all points before the edit. */
  constructor(base: Float32Array) {
    this.#geometry.setAttribute("position", new BufferAttribute(base, 3));
    this.#geometry.setIndex(new BufferAttribute(new Uint32Array(0), 1));
    this.#geometry.boundingSphere = displaySphere();
    this.#materials = PASSES.map(
      (pass) => new LineBasicMaterial({ transparent: true, depthWrite: false, ...pass }),
    );
    for (const material of this.#materials) {
      const lines = new LineSegments(this.#geometry, material);
      lines.frustumCulled = false;
      // Drawn after the panels, whose depth tells what they hide.
      lines.renderOrder = 1;
      // Hidden: nothing to draw, and no reason to send a large mesh's points to the graphics card.
      lines.visible = false;
      this.object.add(lines);
    }
  }

  setColour(colour: string): void {
    for (const material of this.#materials) material.color.set(colour);
  }

  /** Shows these edges; `ends` holds both points of every edge of the mesh. */
  draw(seen: ReadonlySet<number>, ends: ArrayLike<number>): void {
    const index = this.#room(2 * seen.size);
    let k = 0;
    for (const edge of seen) {
      index.array[k++] = ends[2 * edge] ?? 0;
      index.array[k++] = ends[2 * edge + 1] ?? 0;
    }
    index.needsUpdate = true;
    this.#geometry.setDrawRange(0, k);
    for (const lines of this.object.children) lines.visible = k > 0;
  }

  dispose(): void {
    this.#geometry.dispose();
    for (const material of this.#materials) material.dispose();
  }

  /** Room for `count` indices. A replaced index stays in graphics memory until its geometry goes. */
  #room(count: number): BufferAttribute {
    const geometry = this.#geometry;
    if (geometry.index && geometry.index.count >= count) return geometry.index;
    geometry.dispose();
    const index = new BufferAttribute(new Uint32Array(2 * count), 1).setUsage(DynamicDrawUsage);
    geometry.setIndex(index);
    return index;
  }
}
