// SPDX-License-Identifier: MIT
// The second layer of a design on screen: translucent, and nothing that is picked.

import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshStandardMaterial,
} from "three";
import { displaySphere } from "../../scene/framing.ts";
import type { Palette } from "../../scene/palette.ts";
import { placed } from "../../scene/placing.ts";
import type { Shell } from "../../scene/shell.ts";
import type { MeshOffset } from "../../solver/protocol.ts";
import type { Page } from "../../state/page.ts";

/** The design is seen through it, and it through nothing. */
const OPACITY = 0.4;

const INK = 0.8;

/** `points`: of every corner of the panels. */
function cornersOf(points: Float32Array, { vertices }: Shell): Float32Array {
  const corners = new Float32Array(3 * vertices.length);
  vertices.forEach((v, corner) => {
    corners.set(points.subarray(3 * v, 3 * v + 3), 3 * corner);
  });
  return corners;
}

function geometryOf(points: Float32Array, index: Uint32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  geometry.setIndex(new BufferAttribute(index, 1));
  geometry.boundingSphere = displaySphere();
  return geometry;
}

/** Adds the layer to what the shell shows; dispose() takes it away. */
export function layOffset(
  page: Page,
  shell: Shell,
  layer: MeshOffset,
  palette: Palette,
): { dispose(): void } {
  const points = placed(
    layer.positions,
    page.mesh.peek()?.report ?? { centre: [0, 0, 0], scale: 1 },
  );
  const panels = new Mesh(
    geometryOf(cornersOf(points, shell), shell.triangles.slice()),
    new MeshStandardMaterial({
      color: palette.ghost,
      transparent: true,
      opacity: OPACITY,
      depthWrite: false,
      flatShading: true,
      side: DoubleSide,
    }),
  );
  const edges = new LineSegments(
    geometryOf(points, Uint32Array.from(shell.topology.edges)),
    new LineBasicMaterial({ color: palette.ghost, transparent: true, opacity: INK }),
  );
  const group = new Group().add(panels, edges);
  shell.group.add(group);
  return {
    dispose() {
      group.removeFromParent();
      for (const part of [panels, edges]) {
        part.geometry.dispose();
        part.material.dispose();
      }
    },
  };
}
