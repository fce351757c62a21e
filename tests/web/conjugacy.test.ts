// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { conjugacy, UNKNOWN } from "../../web/src/features/planarising/conjugacy.ts";
import { netFault } from "../../web/src/features/planarising/net-angles.ts";
import { buildTopology } from "../../web/src/mesh/topology.ts";

type Point = readonly [number, number, number];

const COUNT = 12;

/** Panels of a net over (s, t), both −1 … 1. */
function angles(surface: (s: number, t: number) => Point, count = COUNT): Float32Array {
  const at = (k: number): number => (2 * k) / count - 1;
  const side = Array.from({ length: count + 1 }, (_, k) => at(k));
  const positions = Float64Array.from(side.flatMap((t) => side.flatMap((s) => surface(s, t))));
  const faces = Array.from({ length: count * count }, (_, f) => {
    const a = Math.floor(f / count) * (count + 1) + (f % count);
    return [a, a + 1, a + count + 2, a + count + 1];
  });
  const vertices = Int32Array.from(faces.flat());
  const offsets = Int32Array.from({ length: faces.length + 1 }, (_, f) => 4 * f);
  const topology = buildTopology(offsets, vertices, positions.length / 3);
  return conjugacy({ positions, vertices, offsets, topology });
}

/** The same net, its lines turned by `degrees` in the plane below. */
const turned =
  (height: (x: number, y: number) => number, degrees: number) =>
  (s: number, t: number): Point => {
    const [cos, sin] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
    const [x, y] = [cos * s - sin * t, sin * s + cos * t];
    return [x, y, height(x, y)];
  };

const most = (of: Float32Array): number => Math.max(...of);
const least = (of: Float32Array): number => Math.min(...of);

/** Degrees: what is left of a quadric over a slanted plane, fitted to few points. */
const FITTED = 2;

it("a net of translation is conjugate, also where its lines are not principal", () => {
  expect(most(angles((s, t) => [s, t, 0.2 * s * s + 0.3 * t * t]))).toBeLessThan(FITTED);
  const slanted = (s: number, t: number): Point => [s + 0.4 * t, t, 0.2 * s * s - 0.3 * t * t];
  expect(most(angles(slanted))).toBeLessThan(FITTED);
  expect(least(angles(slanted))).toBeGreaterThanOrEqual(0);
});

it("a net of straight lines on a saddle is as far off as can be: 90°", () => {
  const saddle = (x: number, y: number): number => 0.2 * x * y;
  const all = angles(turned(saddle, 0));
  expect(least(all)).toBeGreaterThan(85);
  // Turned to its principal lines the same saddle has a conjugate net.
  expect(most(angles(turned(saddle, 45)))).toBeLessThan(FITTED);
});

it("on a cylinder lines are off by how far the nearer of them is from its rulings", () => {
  const cylinder = (x: number): number => Math.sqrt(9 - x * x) - 3;
  expect(most(angles(turned(cylinder, 0)))).toBeLessThan(0.1);
  for (const degrees of [10, 30, 45]) {
    const all = angles(turned(cylinder, degrees), 24);
    const middle = all[24 * 12 + 12] ?? Number.NaN;
    expect(Math.abs(middle - degrees)).toBeLessThan(1);
  }
});

it("does not depend on where a net is, how large, or which way up", () => {
  const net = turned((x, y) => 0.3 * x * x + 0.1 * x * y - 0.2 * y * y, 20);
  const moved = (s: number, t: number): Point => {
    const [x, y, z] = net(s, t);
    return [5000 + 1000 * z, -3000 + 1000 * x, 1000 * y];
  };
  const [here, there] = [angles(net), angles(moved)];
  expect(most(here)).toBeGreaterThan(5);
  here.forEach((angle, f) => {
    expect(Math.abs(angle - (there[f] ?? Number.NaN))).toBeLessThan(1e-3);
  });
});

it("is not known where a surface is flat, and for panels that are no quads or touch too few", () => {
  expect(new Set(angles((s, t) => [s, t, 0]))).toEqual(new Set([UNKNOWN]));
  expect([...angles((s, t) => [s, t, s * t], 1)]).toEqual([UNKNOWN]);
  const positions = Float64Array.from([0, 0, 0, 1, 0, 0, 0, 1, 1]);
  const [offsets, vertices] = [Int32Array.from([0, 3]), Int32Array.from([0, 1, 2])];
  const topology = buildTopology(offsets, vertices, 3);
  expect([...conjugacy({ positions, offsets, vertices, topology })]).toEqual([UNKNOWN]);
});

it("a net's fault is of the panels that are known, where those are half of all", () => {
  expect(netFault(Float32Array.from([-1, 3, -1, 40, 9]))).toEqual({ half: 9, most: 40 });
  expect(netFault(Float32Array.from([-1, 40, -1, 40]))).toEqual({ half: 40, most: 40 });
  expect(netFault(Float32Array.from([-1, 40, -1, 40, -1]))).toBeNull();
  expect(netFault(Float32Array.from([-1]))).toBeNull();
});
