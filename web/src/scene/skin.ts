// SPDX-License-Identifier: MIT
// What the panels look like: matt, in their colours, or in another skin.
import { type BufferGeometry, DoubleSide, type Material, MeshStandardMaterial } from "three";
import type { Topology } from "../mesh/topology.ts";

export const mattMaterial = (): MeshStandardMaterial =>
  new MeshStandardMaterial({
    vertexColors: true,
    flatShading: true,
    side: DoubleSide,
    roughness: 0.85,
    metalness: 0,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });

/** Another look of the panels than their colours. */
export interface Skin {
  readonly material: Material;
  /** Called after points moved. */
  update(geometry: BufferGeometry, offsets: Int32Array, topology: Topology): void;
  dispose(): void;
}
