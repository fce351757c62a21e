// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import { prepareDisplay } from "../../web/src/mesh/display-mesh.ts";
import { panelAt, triangulate } from "../../web/src/mesh/triangulation.ts";

type Point = readonly [number, number];

const area = ([ax, ay]: Point, [bx, by]: Point, [cx, cy]: Point): number =>
  ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2;

/** Shoelace. */
const polygonArea = (points: readonly Point[]): number =>
  points.reduce((sum, [x, y], k) => {
    const [nx, ny] = points[(k + 1) % points.length] ?? [0, 0];
    return sum + (x * ny - y * nx) / 2;
  }, 0);

/** Areas of the triangles of one panel that lies in a tilted plane, most along axis `facing`. */
function cut(points: readonly Point[], facing: number): number[] {
  const corners = Float32Array.from(
    points.flatMap(([x, y]) => {
      const at = [x, y, 0.5 * x - 0.25 * y];
      return [0, 1, 2].map((axis) => at[(axis + 2 - facing) % 3] ?? 0);
    }),
  );
  const triangles = triangulate(corners, Int32Array.of(0, points.length));
  const areas: number[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const [a = [0, 0], b = [0, 0], c = [0, 0]] = [...triangles.slice(t, t + 3)].map(
      (k): Point => points[k] ?? [0, 0],
    );
    areas.push(area(a, b, c));
  }
  return areas;
}

const ARROW: readonly Point[] = [
  [0, 0],
  [2, -1],
  [0.5, 0],
  [2, 1],
];
const BOW: readonly Point[] = [
  [0, 0],
  [2, 0.8],
  [4, 0],
  [4, 2],
  [2, 1.2],
  [0, 2],
];
const COMB: readonly Point[] = [
  [0, 0],
  [6, 0],
  [6, 3],
  [5, 3],
  [5, 1],
  [3, 1],
  [3, 3],
  [2, 3],
  [2, 1],
  [0, 1],
];

describe("triangles of a panel", () => {
  it.each([
    ["an arrow head", 2, ARROW],
    ["an arrow head", 1, ARROW],
    ["an arrow head", 0, ARROW],
    ["a bow tie of six corners", 2, BOW],
    ["a comb", 2, COMB],
    ["a comb", 1, COMB],
    ["a comb", 0, COMB],
  ] as const)(
    "cover %s that faces along axis %i once and stay inside it, from every first corner and both ways round",
    (_, facing, shape) => {
      for (let turn = 0; turn < shape.length; ++turn) {
        const turned = [...shape.slice(turn), ...shape.slice(0, turn)];
        for (const points of [turned, [...turned].reverse()]) {
          const areas = cut(points, facing);
          const sign = Math.sign(polygonArea(points));
          expect(areas.length).toBe(points.length - 2);
          expect(areas.every((a) => sign * a >= -1e-6)).toBe(true);
          expect(areas.reduce((a, b) => a + b, 0)).toBeCloseTo(polygonArea(points), 5);
        }
      }
    },
  );

  it("lie at the same place whatever the shape, so that a panel can be cut anew", () => {
    const offsets = Int32Array.of(0, 4, 7, 13);
    const display = Float32Array.from(
      [...ARROW, ...ARROW.slice(0, 3), ...BOW].flatMap(([x, y]) => [x, y, 0]),
    );
    const vertices = Int32Array.from({ length: 13 }, (_, k) => k);
    const { triangles } = prepareDisplay({ display, offsets, vertices });
    const panels = [...triangles].map((corner) => panelAt(offsets, corner));
    expect(panels).toEqual([...Array(6).fill(0), ...Array(3).fill(1), ...Array(12).fill(2)]);
  });

  it("of a panel that folds back on itself are fewer, and those left over are its first corner", () => {
    const spike: readonly Point[] = [
      [0, 0],
      [4, 0],
      [4, 4],
      [2, 4],
      [2, 6],
      [2, 4],
      [0, 4],
    ];
    const corners = Float32Array.from([...ARROW, ...spike].flatMap(([x, y]) => [x, y, 0]));
    const triangles = triangulate(corners, Int32Array.of(0, 4, 11));
    const own = Array.from({ length: 5 }, (_, t) => [...triangles.slice(6 + 3 * t, 9 + 3 * t)]);
    const empty = own.filter((triangle) => new Set(triangle).size === 1);
    expect(empty.length).toBeGreaterThan(0);
    expect(empty).toEqual(empty.map(() => [4, 4, 4]));
  });
});
