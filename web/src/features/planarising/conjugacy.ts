// SPDX-License-Identifier: MIT
// How far the lines of a net are from conjugate directions of the surface that they run on: panels between
// conjugate lines are flat in the limit of small panels, others cannot be.

import type { Polygons } from "../../mesh/display-mesh.ts";
import { row, type Topology } from "../../mesh/topology.ts";
import { panelAt } from "../../mesh/triangulation.ts";
import { add, cross, dot, minus, type Vector } from "../../mesh/vector.ts";
import { Quadric } from "./quadric.ts";

type Net = Omit<Polygons, "display"> & {
  readonly topology: Topology;
  readonly positions: Float64Array;
};

/** Of a panel where it is not known: no quad, too few neighbours, or a surface that is flat there. */
export const UNKNOWN = -1;

/** Radians that a surface turns by along a panel: below, whatever its lines do bends panels by 1 mm/m at most. */
const LEAST_TURN = 0.002;

type Hessian = readonly [xx: number, xy: number, yy: number];

type Plane = readonly [x: Vector, y: Vector, normal: Vector];

const times = (v: Vector, t: number): Vector => add([0, 0, 0], v, t);

const unit = (v: Vector): Vector => times(v, 1 / (Math.hypot(...v) || 1));

const pointAt = ({ positions }: Net, v: number): Vector => [
  positions[3 * v] ?? 0,
  positions[3 * v + 1] ?? 0,
  positions[3 * v + 2] ?? 0,
];

const cornersOf = ({ vertices, offsets }: Net, panel: number): Int32Array =>
  vertices.subarray(offsets[panel], offsets[panel + 1]);

/** Corners of the panel and of those that touch it. */
function pointsAround(net: Net, panel: number): number[] {
  const points: number[] = [];
  for (const v of cornersOf(net, panel))
    for (const place of row(net.topology.corners, v))
      for (const w of cornersOf(net, panelAt(net.offsets, place)))
        if (!points.includes(w)) points.push(w);
  return points;
}

/** Degrees between `v` and the direction conjugate to `u`, 0 to 90. */
function off([x, y]: Plane, [xx, xy, yy]: Hessian, u: Vector, v: Vector): number {
  const [along, across] = [dot(u, x), dot(u, y)];
  const w = add(times(x, -(xy * along + yy * across)), y, xx * along + xy * across);
  return (180 / Math.PI) * Math.atan2(Math.hypot(...cross(w, v)), Math.abs(dot(w, v)));
}

function angleOf(net: Net, panel: number, quadric: Quadric): number {
  const [a, b, c, d, more] = Array.from(cornersOf(net, panel), (v) => pointAt(net, v));
  if (!a || !b || !c || !d || more) return UNKNOWN;
  const u = times(minus(add(b, c), add(a, d)), 0.5);
  const v = times(minus(add(c, d), add(a, b)), 0.5);
  const [scale, middle] = [Math.hypot(...u, ...v) || 1, times(add(add(a, b), add(c, d)), 0.25)];
  const normal = unit(cross(u, v));
  const plane: Plane = [unit(u), cross(normal, unit(u)), normal];
  quadric.clear();
  for (const w of pointsAround(net, panel)) {
    const at = times(minus(pointAt(net, w), middle), 1 / scale);
    quadric.add(dot(at, plane[0]), dot(at, plane[1]), dot(at, normal));
  }
  const hessian = quadric.hessian();
  if (!hessian || Math.hypot(...hessian) < LEAST_TURN) return UNKNOWN;
  // Where the surface bends one way alone, turning one of the two lines a little is enough.
  return Math.min(off(plane, hessian, u, v), off(plane, hessian, v, u));
}

/** Degrees for each panel by which one of its two lines has to turn to be conjugate to the other: 0 to 90, or
 * UNKNOWN. Of quads alone: lines of others do not go on. */
export function conjugacy(net: Net): Float32Array {
  const quadric = new Quadric();
  return Float32Array.from({ length: net.offsets.length - 1 }, (_, panel) =>
    angleOf(net, panel, quadric),
  );
}
