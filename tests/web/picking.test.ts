// SPDX-License-Identifier: MIT
// Points are picked by where they are on screen, whatever lies between them and the pointer.
import { PerspectiveCamera } from "three";
import { describe, expect, it } from "vitest";
import { buildTopology } from "../../web/src/mesh/topology.ts";
import { pickVertex, project, type View, verticesIn } from "../../web/src/scene/picking.ts";

/** Two quads side by side, 0-1-2 above 3-4-5, seen straight on; 1 unit is about 100 pixels. */
const points = Float32Array.of(-1, 1, 0, 0, 1, 0, 1, 1, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0);
const topology = buildTopology(
  Int32Array.of(0, 4, 8),
  Int32Array.of(0, 1, 4, 3, 1, 2, 5, 4),
  points.length / 3,
);

function viewFrom(distance: number): View {
  const camera = new PerspectiveCamera(40, 1.5, 0.1, 100);
  camera.position.set(0, 0, distance);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  return { camera, width: 900, height: 600 };
}

const view = viewFrom(8);

function at(vertex: number): { x: number; y: number } {
  const place = project(points, vertex, view);
  if (!place) throw new Error("behind the camera");
  return place;
}

const pick = (x: number, y: number, coarse = false): number | null =>
  pickVertex(points, topology, x, y, coarse, view);

describe("the point under a pixel", () => {
  it("is the nearest on screen", () => {
    for (let v = 0; v < 6; ++v) {
      const { x, y } = at(v);
      expect(pick(x + 4, y - 9)).toBe(v);
    }
  });

  it("is none further away than a mouse is unsure by, and a finger reaches further", () => {
    const { x, y } = at(4);
    expect(pick(x + 24, y)).toBe(null);
    expect(pick(x + 24, y, true)).toBe(4);
    expect(pick(x + 40, y + 20, true)).toBe(null);
  });

  it("is the near one where two lie behind each other", () => {
    const stacked = points.slice();
    stacked.set([0, 0, 2], 3);
    expect(pickVertex(stacked, topology, at(4).x, at(4).y, false, view)).toBe(1);
  });

  it("leaves the middle of a small panel to the panel", () => {
    const far = viewFrom(60);
    const [a, b] = [project(points, 4, far), project(points, 2, far)];
    if (!a || !b) throw new Error("behind the camera");
    const middle = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
    expect(Math.hypot(a.x - middle.x, a.y - middle.y)).toBeLessThan(18);
    expect(pickVertex(points, topology, middle.x, middle.y, false, far)).toBe(null);
  });
});

it("a box holds what lies in it on screen", () => {
  const [from, to] = [at(1), at(5)];
  const box = { left: from.x - 1, top: from.y - 1, right: to.x + 1, bottom: to.y + 1 };
  expect(verticesIn(box, points, view)).toEqual([1, 2, 4, 5]);
});
