// SPDX-License-Identifier: MIT
// Panels are chosen by a click on or near them, also where they are seen almost from the edge.
import { PerspectiveCamera, Raycaster, Vector2 } from "three";
import { describe, expect, it } from "vitest";
import { prepareDisplay } from "../../web/src/mesh/display-mesh.ts";
import { pickPanel, type Surface } from "../../web/src/scene/panel-picking.ts";
import { project, type View } from "../../web/src/scene/picking.ts";

/**
 * Seen from above, 1 unit is about 103 pixels: panel 0 lies flat, panel 1 stands on its right edge
 * (x from 1 to 1.02), panel 2 lies flat beyond it, panel 3 stands like panel 1 below panel 0.
 */
const mesh = prepareDisplay({
  display: Float32Array.of(
    ...[-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0],
    ...[1.02, -1, 1, 1.02, 1, 1, 3, -1, 1, 3, 1, 1],
    ...[-0.5, -0.8, -1, -0.5, 0.8, -1, -0.48, 0.8, -2, -0.48, -0.8, -2],
  ),
  offsets: Int32Array.of(0, 4, 8, 12, 16),
  vertices: Int32Array.of(0, 1, 2, 3, 1, 4, 5, 2, 4, 6, 7, 5, 8, 9, 10, 11),
});

const camera = new PerspectiveCamera(40, 1.5, 0.1, 100);
camera.position.set(0, 0, 8);
camera.updateMatrixWorld();
const view: View = { camera, width: 900, height: 600 };

/** The pixel that shows a place. */
function pixel(x: number, y: number, z: number): { x: number; y: number } {
  const at = project(Float32Array.of(x, y, z), 0, view);
  if (!at) throw new Error("behind the camera");
  return at;
}

function pick(at: { x: number; y: number }, coarse = false, surface: Surface = mesh) {
  const caster = new Raycaster();
  return pickPanel(surface, at, coarse, view, ({ x, y }) => {
    caster.setFromCamera(new Vector2((2 * x) / 900 - 1, 1 - (2 * y) / 600), camera);
    return caster.ray.clone();
  });
}

const moved = ({ x, y }: { x: number; y: number }, dx: number, dy = 0) => ({
  x: x + dx,
  y: y + dy,
});

describe("a click on panels", () => {
  it("chooses the one under it", () => {
    expect(pick(pixel(0, 0, 0))).toBe(0);
    expect(pick(pixel(2, 0.5, 1))).toBe(2);
  });

  it("just beside the model chooses its nearest panel, further away none", () => {
    const edge = pixel(-1, 0.3, 0);
    expect(pick(moved(edge, -6))).toBe(0);
    expect(pick(moved(edge, -12))).toBe(null);
    expect(pick(moved(edge, -12), true)).toBe(0);
  });
});

describe("a panel seen almost from the edge", () => {
  const foot = pixel(1, 0, 0);

  it("is chosen by a click within a few pixels, beside it the wide ones are", () => {
    const top = pixel(1.02, 0, 1);
    expect(Math.abs(top.x - foot.x)).toBeGreaterThan(5);
    const narrow = { ...mesh, corners: mesh.corners.slice() };
    // The sliver's top edge (corners 5 and 6) comes to 2 pixels from its foot, and so does panel 2.
    for (const corner of [5, 6, 8, 11]) narrow.corners[3 * corner] = 0.893;
    const sliver = pixel(0.893, 0, 1);
    expect(Math.abs(sliver.x - foot.x)).toBeLessThan(4);
    expect(pick(moved(foot, -1), false, narrow)).toBe(1);
    expect(pick(moved(foot, -2.5), false, narrow)).toBe(1);
    expect(pick(moved(foot, -9), false, narrow)).toBe(0);
    expect(pick(moved(foot, 12), false, narrow)).toBe(2);
  });

  it("is chosen by a click on it, although its middle is hidden and a neighbour's is not", () => {
    // Panels 0 and 1, 3 pixels wide, lie side by side; panel 2 hides the middle of panel 0.
    const covered = prepareDisplay({
      display: Float32Array.of(
        ...[0, -1, 0, 0.03, -1, 0, 0.03, 1, 0, 0, 1, 0],
        ...[0.04, 0.5, 0, 0.07, 0.5, 0, 0.07, 0.9, 0, 0.04, 0.9, 0],
        ...[-0.3, -0.3, 0.5, 0.3, -0.3, 0.5, 0.3, 0.3, 0.5, -0.3, 0.3, 0.5],
      ),
      offsets: Int32Array.of(0, 4, 8, 12),
      vertices: Int32Array.from({ length: 12 }, (_, k) => k),
    });
    expect(pick(pixel(0.015, 0, 0), false, covered)).toBe(2);
    expect(pick(pixel(0.015, 0.7, 0), false, covered)).toBe(0);
    expect(pick(pixel(0.055, 0.7, 0), false, covered)).toBe(1);
  });

  it("is not chosen through another one", () => {
    expect(pick(pixel(-0.49, 0, -1.5))).toBe(0);
  });
});
