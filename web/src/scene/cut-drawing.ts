// SPDX-License-Identifier: MIT
// The sides that a cut would add, and the places that it would go through, over the structure.
import { BufferAttribute, BufferGeometry, Points, PointsMaterial } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Drawn } from "./drawing-follower.ts";
import type { Stage } from "./stage.ts";

/** Pixels. */
const [WIDTH, SIZE] = [3, 9];

/** Over the edges of the panels, and through what hides them. */
const OVER = { transparent: true, depthTest: false } as const;

/** @param lines x, y, z of both ends of each  @param places x, y, z of each; display coordinates */
export function drawCut(
  { scene }: Stage,
  lines: Float32Array,
  places: Float32Array,
  colour: string,
): Drawn {
  const sides = new LineSegments2(
    new LineSegmentsGeometry(),
    new LineMaterial({ ...OVER, color: colour, linewidth: WIDTH }),
  );
  if (lines.length > 0) sides.geometry.setPositions(lines);
  const marks = new Points(
    new BufferGeometry().setAttribute("position", new BufferAttribute(places, 3)),
    new PointsMaterial({ ...OVER, color: colour, size: SIZE, sizeAttenuation: false }),
  );
  sides.visible = lines.length > 0;
  const parts = [sides, marks];
  for (const part of parts) {
    part.frustumCulled = false;
    part.renderOrder = 3; // over the outline of a panel
    scene.add(part);
  }
  return {
    dispose() {
      for (const part of parts) {
        part.removeFromParent();
        part.geometry.dispose();
        part.material.dispose();
      }
    },
  };
}
