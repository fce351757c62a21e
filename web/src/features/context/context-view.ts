// SPDX-License-Identifier: MIT
// What a Rhino model held beside its panels: grey, behind them, and nothing that a pointer finds.
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  type Material,
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  type Scene,
} from "three";
import type { Context } from "../../rhino/context.ts";
import { displaySphere } from "../../scene/framing.ts";
import { type Placing, placed } from "../../scene/placing.ts";

const GREY = { light: "#77746C", dark: "#8C9095" } as const;
/** Half a cross that stands for a point, display units. */
const CROSS = 0.05;

function crosses(points: Float32Array): Float32Array {
  const ends = new Float32Array(6 * points.length);
  for (let k = 0; k < points.length; k += 3)
    for (let axis = 0; axis < 3; ++axis)
      for (let end = 0; end < 2; ++end) {
        const at = 6 * k + 6 * axis + 3 * end;
        ends.set(points.subarray(k, k + 3), at);
        ends[at + axis] = (ends[at + axis] ?? 0) + (end === 0 ? -CROSS : CROSS);
      }
  return ends;
}

function geometryOf(positions: Float32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.boundingSphere = displaySphere();
  return geometry;
}

export class ContextView {
  readonly #object = new Group();
  readonly #materials: readonly Material[];

  constructor(scene: Scene, context: Context, placing: Placing, dark: boolean) {
    const color = dark ? GREY.dark : GREY.light;
    const look = { color, transparent: true, depthWrite: false };
    const line = new LineBasicMaterial({ ...look, opacity: 0.5 });
    const face = new MeshStandardMaterial({
      ...look,
      flatShading: true,
      side: DoubleSide,
      roughness: 1,
      metalness: 0,
      opacity: 0.3,
    });
    this.#materials = [line, face];
    this.#add(context.lines, (ends) => new LineSegments(geometryOf(ends), line), placing);
    this.#add(context.points, (at) => new LineSegments(geometryOf(crosses(at)), line), placing);
    this.#add(context.triangles, (at) => new Mesh(geometryOf(at), face), placing);
    scene.add(this.#object);
  }

  #add(list: Float64Array, make: (points: Float32Array) => Object3D, placing: Placing): void {
    if (list.length === 0) return;
    const object = make(placed(list, placing));
    object.frustumCulled = false; // looking at every point to find their middle takes long
    object.renderOrder = -1; // before the ground, which would hide what is below it
    this.#object.add(object);
  }

  dispose(): void {
    this.#object.removeFromParent();
    for (const object of this.#object.children) (object as LineSegments).geometry.dispose();
    for (const material of this.#materials) material.dispose();
  }
}
