// SPDX-License-Identifier: MIT
// Points are picked by where they are on screen, whatever lies between them and the pointer.
import { PerspectiveCamera } from "three";
import { describe, expect, it } from "vitest";
import { buildTopology } from "../../web/src/mesh/topology.ts";
import { verticesIn } from "../../web/src/scene/area-picking.ts";
import { boxAround } from "../../web/src/scene/outline.ts";
import { pickVertex, project, type View } from "../../web/src/scene/picking.ts";

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

const shown = (current: Float32Array, isShown = (_: number): boolean => true) => ({
  current,
  topology,
  isShown,
});

const pick = (x: number, y: number, coarse = false): number | null =>
  pickVertex(shown(points), { x, y }, coarse, view);

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
    expect(pickVertex(shown(stacked), at(4), false, view)).toBe(1);
  });

  it("is never one that is hidden", () => {
    const { x, y } = at(4);
    const others = shown(points, (vertex) => vertex !== 4);
    expect(pickVertex(others, { x, y }, false, view)).toBeNull();
    expect(pickVertex(others, at(5), false, view)).toBe(5);
    const all = boxAround({ x: 0, y: 0 }, { x: 900, y: 600 });
    expect(verticesIn(all, others, view)).toEqual([0, 1, 2, 3, 5]);
  });

  it("leaves the middle of a small panel to the panel", () => {
    const far = viewFrom(60);
    const [a, b] = [project(points, 4, far), project(points, 2, far)];
    if (!a || !b) throw new Error("behind the camera");
    const middle = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
    expect(Math.hypot(a.x - middle.x, a.y - middle.y)).toBeLessThan(18);
    expect(pickVertex(shown(points), middle, false, far)).toBe(null);
  });
});

it("a box holds what lies in it on screen, a loop what it goes round", () => {
  const [from, to] = [at(1), at(5)];
  const box = boxAround({ x: from.x - 1, y: from.y - 1 }, { x: to.x + 1, y: to.y + 1 });
  expect(verticesIn(box, shown(points), view)).toEqual([1, 2, 4, 5]);
  const past = (v: number, x: number, y: number) => ({ x: at(v).x + x, y: at(v).y + y });
  const loop = [
    past(0, -9, -9),
    past(2, 9, -9),
    past(2, 9, 9),
    past(1, 0, 9),
    past(3, 9, 9),
    past(3, -9, 9),
  ];
  expect(verticesIn(loop, shown(points), view)).toEqual([0, 1, 2, 3]);
  expect(verticesIn([], shown(points), view)).toEqual([]);
});
