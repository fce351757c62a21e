// SPDX-License-Identifier: MIT
// A plane that cuts the structure open: what is beyond it is left out of the picture, and the cut is a
// line.
import {
  BufferAttribute,
  BufferGeometry,
  LineBasicMaterial,
  LineSegments,
  type Material,
  Mesh,
  type Object3D,
  Plane,
  Vector3,
} from "three";
import type { SectionPlane } from "../../design/section-plane.ts";
import type { PlaneSection } from "../../mesh/plane-section.ts";
import type { Drawn } from "../../scene/drawing-follower.ts";
import { placed, placedAlong } from "../../scene/placing.ts";
import type { Stage } from "../../scene/stage.ts";
import type { OpenedMesh } from "../../solver/protocol.ts";

function clip(structure: Object3D, planes: Plane[] | null): void {
  structure.traverse((part) => {
    if (!(part instanceof Mesh || part instanceof LineSegments)) return;
    const material = part.material as Material;
    if (material.clippingPlanes === planes) return;
    material.clippingPlanes = planes;
    material.needsUpdate = true;
  });
}

function lineOf(
  points: Float32Array,
  colour: string,
): LineSegments<BufferGeometry, LineBasicMaterial> {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  const line = new LineSegments(
    geometry,
    new LineBasicMaterial({ color: colour, depthTest: false }),
  );
  line.frustumCulled = false;
  line.renderOrder = 2; // over what it cuts
  return line;
}

/** Cuts the structure; dispose() makes it whole again. */
export function drawSection(
  {
    stage,
    structure,
    mesh,
    colour,
  }: { stage: Stage; structure: Object3D; mesh: OpenedMesh; colour: string },
  { axis, at, flipped }: SectionPlane,
  { pieces }: PlaneSection,
): Drawn {
  stage.renderer.localClippingEnabled = true;
  const height = placedAlong(axis, at, mesh.report);
  // What is on the plane's own side is kept.
  const normal = new Vector3().setComponent(axis, flipped ? 1 : -1);
  clip(structure, [new Plane(normal, flipped ? -height : height)]);
  const line = lineOf(placed(pieces, mesh.report), colour);
  stage.scene.add(line);
  return {
    dispose() {
      clip(structure, null);
      line.removeFromParent();
      line.geometry.dispose();
      line.material.dispose();
    },
  };
}
