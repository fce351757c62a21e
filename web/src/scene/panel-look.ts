// SPDX-License-Identifier: MIT
// From where a panel that was chosen elsewhere is seen in the view.
import { Box3, type PerspectiveCamera, Vector3 } from "three";
import type { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { DisplayMesh } from "../mesh/display-mesh.ts";
import { facing, outwards } from "./facing.ts";
import type { Standpoint } from "./framing.ts";
import { stretchOf } from "./lens.ts";

/** A standpoint near the panel with these corners, looking as now if that shows it: see facing(). */
export function closer(
  camera: PerspectiveCamera,
  orbit: OrbitControls,
  corners: Float32Array,
  shown: DisplayMesh,
): Standpoint {
  const box = new Box3().setFromArray(corners);
  const target = box.getCenter(new Vector3());
  const arm = camera.position.clone().sub(orbit.target);
  const near = 9 * stretchOf(camera) * box.getSize(new Vector3()).length();
  // An edit does not turn a model inside out: as it was opened tells, also where panels are hidden.
  const outward = outwards(shown.corners, shown.triangles, shown.topology.boundary);
  const towards = facing(corners, arm.clone().normalize(), outward);
  const position = target.clone().addScaledVector(towards, Math.min(arm.length(), near));
  return { position, target };
}
