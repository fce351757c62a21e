// SPDX-License-Identifier: MIT
// What the frames of glass are drawn by: in a flat panel, how far every place is from its nearest side.
import { expect, it } from "vitest";
import {
  followCorners,
  meanSide,
  NO_SIDE,
  sidesKept,
  writeSideDistances,
} from "../../web/src/features/analysis/side-distances.ts";

type Places = readonly (readonly [number, number])[];

/** Panels in one slanted plane, so that no axis is special; lengths are those of the plane. */
function panels(...all: readonly Places[]) {
  const offsets = Int32Array.from([0, ...all.map((_, f) => all.slice(0, f + 1).flat().length)]);
  const corners = Float32Array.from(all.flat().flatMap(([x, y]) => [x, 0.6 * y, 0.8 * y]));
  const kept = sidesKept(offsets);
  const out = new Float32Array((kept * corners.length) / 3);
  writeSideDistances(corners, offsets, { array: out, stride: kept });
  return {
    corners,
    offsets,
    kept,
    out,
    row: (corner: number) => [...out.subarray(kept * corner, kept * (corner + 1))],
  };
}

const QUAD: Places = [
  [0, 0],
  [4, 0],
  [3, 2],
  [0, 2],
];

it("a panel's middle is as far from its nearest side as its corners' distances say by interpolation", () => {
  const { row, kept } = panels(QUAD);
  expect(kept).toBe(4);
  // Half way between two corners that face each other.
  const [a, b] = [row(0), row(2)];
  const between = a.map((x, k) => (x + (b[k] ?? 0)) / 2);
  expect(between[0]).toBeCloseTo(1, 5);
  expect(between[2]).toBeCloseTo(1, 5);
  expect(between[3]).toBeCloseTo(1.5, 5);
  // The slanted side, from (4, 0) to (3, 2), of (1.5, 1).
  expect(between[1]).toBeCloseTo(4 / Math.sqrt(5), 5);
});

it("corners lie on their own two sides, whichever way the panel goes round", () => {
  for (const places of [QUAD, [...QUAD].reverse()]) {
    const { row } = panels(places);
    for (let k = 0; k < 4; ++k) {
      expect(row(k)[k]).toBeCloseTo(0, 5);
      expect(row(k)[(k + 3) % 4]).toBeCloseTo(0, 5);
      for (const distance of row(k)) expect(distance).toBeGreaterThan(-1e-5);
    }
  }
});

it("a triangle beside a hexagon has no fourth side, the hexagon all six", () => {
  const hexagon: Places = [0, 1, 2, 3, 4, 5].map((k) => [
    Math.cos((k * Math.PI) / 3),
    Math.sin((k * Math.PI) / 3),
  ]);
  const triangle: Places = [
    [2, 0],
    [3, 0],
    [2, 1],
  ];
  const { row, kept, corners, offsets } = panels(triangle, hexagon);
  expect(kept).toBe(8);
  expect(row(0).slice(3)).toEqual(Array(5).fill(NO_SIDE));
  expect(
    row(3)
      .slice(0, 6)
      .every((x) => x < 2),
  ).toBe(true);
  expect(row(3).slice(6)).toEqual([NO_SIDE, NO_SIDE]);
  expect(meanSide(corners, offsets)).toBeCloseTo((2 + Math.SQRT2 + 6) / 9, 5);
});

it("a side whose line would cut through its panel has no frame, the others have", () => {
  const dart: Places = [
    [0, 0],
    [2, 1],
    [0, 2],
    [0.5, 1],
  ];
  const { row } = panels(dart);
  expect(row(0)).toEqual([expect.closeTo(0, 5), expect.any(Number), NO_SIDE, NO_SIDE]);
  expect(row(0)[1]).toBeLessThan(NO_SIDE);
});

it("after points moved, only the panels at them are written, as they would be anew", () => {
  const moved = QUAD.map(([x, y]) => [x + 10, y] as const);
  const there = panels(QUAD, moved);
  const corners = there.corners.slice();
  corners[3 * 6] = 14;
  const after = panels(
    QUAD,
    moved.map(([x, y], k) => [k === 2 ? 14 : x, y]),
  );
  there.out.fill(-1, 0, 16);
  const wrote: number[] = [];
  const out = { array: there.out, stride: 4 };
  const again = () =>
    followCorners(corners, there.corners, there.offsets, out, (corner) => wrote.push(corner));
  again();
  expect([...there.out.subarray(0, 16)]).toEqual(Array(16).fill(-1));
  for (const corner of [4, 5, 6, 7]) expect(there.row(corner)).toEqual(after.row(corner));
  expect(after.row(6)).not.toEqual(panels(QUAD, moved).row(6));
  expect(wrote).toEqual([4, 7]);
  again();
  expect(wrote.length).toBe(2);
});
