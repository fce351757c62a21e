// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import {
  type LinedMesh,
  lineThrough,
  neighboursOf,
  ringThrough,
} from "../../web/src/mesh/mesh-lines.ts";
import { polylineOf } from "../../web/src/mesh/polyline.ts";
import { buildTopology } from "../../web/src/mesh/topology.ts";

function meshOf(points: readonly (readonly number[])[], faces: readonly number[][]): LinedMesh {
  const starts = [0];
  for (const face of faces) starts.push((starts.at(-1) ?? 0) + face.length);
  const [offsets, vertices] = [Int32Array.from(starts), Int32Array.from(faces.flat())];
  const topology = buildTopology(offsets, vertices, points.length);
  return { points: points.flat(), offsets, vertices, topology };
}

const WIDE = 6;
const HIGH = 5;
const at = (i: number, j: number): number => j * WIDE + i;
const SQUARES = Array.from({ length: HIGH - 1 }, (_, j) =>
  Array.from({ length: WIDE - 1 }, (_, i) => [
    at(i, j),
    at(i + 1, j),
    at(i + 1, j + 1),
    at(i, j + 1),
  ]),
).flat();
const PLACES = Array.from({ length: WIDE * HIGH }, (_, k) => [k % WIDE, Math.floor(k / WIDE), 0]);
const grid = meshOf(PLACES, SQUARES);
const rowOf = (j: number): number[] => Array.from({ length: WIDE }, (_, i) => at(i, j));
const columnOf = (i: number): number[] => Array.from({ length: HIGH }, (_, j) => at(i, j));
const sorted = (all: readonly number[]): number[] => all.toSorted((a, b) => a - b);

describe("on quads", () => {
  it("the line through any edge of a row is the row, in order, from either end", () => {
    for (let j = 0; j < HIGH; ++j) {
      for (let i = 0; i + 1 < WIDE; ++i) {
        expect(lineThrough(grid, [at(i, j), at(i + 1, j)])).toEqual(rowOf(j));
        expect(lineThrough(grid, [at(i + 1, j), at(i, j)])).toEqual(rowOf(j).reverse());
      }
    }
    expect(lineThrough(grid, [at(2, 1), at(2, 2)])).toEqual(columnOf(2));
  });

  it("the strip across an edge holds both of its sides, whole", () => {
    for (let j = 0; j < HIGH; ++j) {
      const strip = ringThrough(grid, [at(2, j), at(3, j)]);
      expect(sorted(strip)).toEqual(sorted([...columnOf(2), ...columnOf(3)]));
    }
    expect(sorted(ringThrough(grid, [at(0, 3), at(0, 2)]))).toEqual([...rowOf(2), ...rowOf(3)]);
  });

  it("neighbours share an edge", () => {
    expect(sorted(neighboursOf(grid.topology, at(2, 2)))).toEqual(
      sorted([at(1, 2), at(3, 2), at(2, 1), at(2, 3)]),
    );
  });

  it("a line ends where three or five panels meet", () => {
    // A corner of a box: three quads about point 0.
    const places = [
      [0, 0, 0],
      [1, 0, 0],
      [1, 1, 0],
      [0, 1, 0],
      [0, 1, 1],
      [0, 0, 1],
      [1, 0, 1],
    ];
    const box = meshOf(places, [
      [0, 1, 2, 3],
      [0, 3, 4, 5],
      [0, 5, 6, 1],
    ]);
    expect(lineThrough(box, [1, 0])).toEqual([1, 0]);
  });
});

it("round a tube lines and strips close", () => {
  const around = 8;
  const point = (k: number, z: number): number => z * around + (k % around);
  const places = Array.from({ length: 3 * around }, (_, v) => {
    const angle = (2 * Math.PI * (v % around)) / around;
    return [Math.cos(angle), Math.sin(angle), Math.floor(v / around)];
  });
  const faces = [0, 1].flatMap((z) =>
    Array.from({ length: around }, (_, k) => [
      point(k, z),
      point(k + 1, z),
      point(k + 1, z + 1),
      point(k, z + 1),
    ]),
  );
  const tube = meshOf(places, faces);
  expect(sorted(lineThrough(tube, [point(3, 1), point(4, 1)]))).toEqual(
    Array.from({ length: around }, (_, k) => point(k, 1)),
  );
  expect(ringThrough(tube, [point(2, 0), point(2, 1)]).length).toBe(2 * around);
  // The boundary is a line too.
  expect(lineThrough(tube, [point(0, 0), point(1, 0)]).length).toBe(around);
});

describe("on triangles", () => {
  const faces = SQUARES.flatMap(([a = 0, b = 0, c = 0, d = 0]) => [
    [a, b, c],
    [a, c, d],
  ]);
  const triangles = meshOf(PLACES, faces);

  it("goes straight on where six meet, and along the boundary", () => {
    expect(lineThrough(triangles, [at(2, 2), at(3, 2)])).toEqual(rowOf(2));
    expect(lineThrough(triangles, [at(1, 1), at(2, 2)])).toEqual(
      [0, 1, 2, 3, 4].map((k) => at(k, k)),
    );
    expect(lineThrough(triangles, [at(2, 0), at(3, 0)])).toEqual(rowOf(0));
  });

  it("has no strips", () => {
    expect(ringThrough(triangles, [at(2, 2), at(3, 2)])).toEqual([at(2, 2), at(3, 2)]);
  });
});

it("on hexagons a line is an edge", () => {
  const places = Array.from({ length: 10 }, (_, v) => [v, v % 2, 0]);
  const pair = meshOf(places, [
    [0, 1, 2, 3, 4, 5],
    [2, 1, 6, 7, 8, 9],
  ]);
  expect(lineThrough(pair, [1, 2])).toEqual([1, 2]);
});

describe("points in the order of a line", () => {
  it("are found from any order, open or closed", () => {
    expect(polylineOf(grid.topology, [...rowOf(2)].reverse())).toEqual(rowOf(2));
    expect(polylineOf(grid.topology, [at(1, 1), at(0, 0), at(0, 1)])).toEqual([
      at(0, 0),
      at(0, 1),
      at(1, 1),
    ]);
    const square = [at(2, 1), at(1, 2), at(1, 1), at(2, 2)];
    const closed = polylineOf(grid.topology, square);
    expect(closed?.length).toBe(5);
    expect(closed?.[0]).toBe(closed?.at(-1));
    expect(sorted(closed?.slice(1) ?? [])).toEqual(sorted(square));
  });

  it("are none where they are single, in pieces or branch", () => {
    expect(polylineOf(grid.topology, [])).toBeNull();
    expect(polylineOf(grid.topology, [3])).toBeNull();
    expect(polylineOf(grid.topology, [at(0, 0), at(1, 0), at(3, 0), at(4, 0)])).toBeNull();
    expect(polylineOf(grid.topology, [...rowOf(2), at(2, 1)])).toBeNull();
    const squares = [at(0, 0), at(1, 0), at(0, 1), at(1, 1)];
    const apart = [at(3, 2), at(4, 2), at(3, 3), at(4, 3)];
    expect(polylineOf(grid.topology, [...squares, ...apart])).toBeNull();
  });
});
