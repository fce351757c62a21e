// SPDX-License-Identifier: MIT
// From where a panel that was chosen elsewhere is seen in the view.

import { Box3, type PerspectiveCamera, Quaternion, Vector3 } from "three";
import type { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { DisplayMesh } from "../mesh/display-mesh.ts";
import { areaVector } from "../mesh/triangulation.ts";
import type { Standpoint } from "./framing.ts";
import { stretchOf } from "./lens.ts";

/** Further from the panel's normal than this a view is turned, to this angle. */
const GRAZING = (75 * Math.PI) / 180;
const TURNED = (45 * Math.PI) / 180;

/**
 * Which way panels of a closed model face: 1 if their normals point out of it, −1 if into it; 0 for
 * an open one, which has no inside. By the sign of the volume within.
 * @param boundary 1 for points on an open edge
 */
export function outwards(
  corners: Float32Array,
  triangles: Uint32Array,
  boundary: Uint8Array,
): number {
  if (boundary.includes(1)) return 0;
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  let volume = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    a.fromArray(corners, 3 * (triangles[t] ?? 0));
    b.fromArray(corners, 3 * (triangles[t + 1] ?? 0));
    c.fromArray(corners, 3 * (triangles[t + 2] ?? 0));
    volume += a.dot(b.cross(c));
  }
  return Math.sign(volume);
}

/**
 * The direction from a panel to a camera that shall show it: `towards` itself if the panel is seen
 * well from there, else turned the least way to where it is.
 * @param towards of length 1
 * @param outward see outwards()
 */
export function facing(corners: Float32Array, towards: Vector3, outward: number): Vector3 {
  const normal = new Vector3(...areaVector(corners, 0, corners.length / 3)).normalize();
  normal.multiplyScalar(outward !== 0 ? outward : normal.dot(towards) < 0 ? -1 : 1);
  if (normal.lengthSq() === 0 || normal.angleTo(towards) <= GRAZING) return towards.clone();
  const axis = new Vector3().crossVectors(normal, towards);
  // Seen right from behind, every way is as long: one that keeps up upright.
  if (axis.lengthSq() < 1e-12) axis.set(normal.y, -normal.x, 0);
  if (axis.lengthSq() < 1e-12) axis.set(1, 0, 0);
  return normal.applyQuaternion(new Quaternion().setFromAxisAngle(axis.normalize(), TURNED));
}

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
