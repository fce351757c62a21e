// SPDX-License-Identifier: MIT
// Where a scene is looked at from: near enough to see the edit, with the mesh around it.
import { handles, sampleMesh } from "./recipes.mjs";

/** The display spans this much, as in wasm/session.cpp. */
const DISPLAY_SIZE = 10;
/** Display units; the field of view is 28 degrees. */
const DISTANCE = 11.5;
/** How far the view's centre stays towards the middle of the mesh. */
const TOWARDS_MIDDLE = 0.35;

/** Towards the viewer, by sample; the others are seen whole. */
const DIRECTIONS = {
  freeform: [-0.35, -0.62, 0.72],
  hex: [-0.3, -0.75, 0.6],
  trihex: [-0.3, -0.75, 0.6],
};

const rounded = (vector) => vector.map((x) => Number(x.toFixed(3)));

/** Position and target in display coordinates; null for the page's own view of the whole. */
export function cameraOf(scene) {
  const direction = DIRECTIONS[scene.mesh.split(":")[0]];
  if (!direction) return null;
  const { points } = sampleMesh(scene.mesh);
  const low = [0, 1, 2].map((axis) => Math.min(...points.map((p) => p[axis])));
  const high = [0, 1, 2].map((axis) => Math.max(...points.map((p) => p[axis])));
  const scale = DISPLAY_SIZE / Math.hypot(...high.map((x, axis) => x - low[axis]));
  const [{ vertex }] = handles(scene);
  const target = points[vertex].map(
    (x, axis) => (x - (low[axis] + high[axis]) / 2) * scale * (1 - TOWARDS_MIDDLE),
  );
  const length = Math.hypot(...direction);
  const position = target.map((x, axis) => x + (DISTANCE * direction[axis]) / length);
  return { position: rounded(position), target: rounded(target) };
}
