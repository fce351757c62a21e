// SPDX-License-Identifier: MIT
// What can be measured between points, in the order in which they were chosen.
import { add, minus, type Vector } from "./vector.ts";

export interface Measure {
  readonly name: string;
  readonly value: number;
  /** A length is in the unit of the points. */
  readonly kind: "length" | "degrees";
}

const length = (name: string, value: number): Measure => ({ name, value, kind: "length" });
const degrees = (name: string, value: number): Measure => ({ name, value, kind: "degrees" });

const toDegrees = (radians: number): number => (radians * 180) / Math.PI;

const gap = (a: Vector, b: Vector): Vector => minus(b, a);

const distance = (a: Vector, b: Vector): number => Math.hypot(...gap(a, b));

function ofTwo(a: Vector, b: Vector): Measure[] {
  const [x, y, z] = gap(a, b);
  const plan = Math.hypot(x, y);
  return [
    length("Distance", Math.hypot(x, y, z)),
    length("In x", x),
    length("In y", y),
    length("In z", z),
    length("In plan", plan),
    degrees("Slope", toDegrees(Math.atan2(z, plan))),
  ];
}

/** At `b`, between the ways to `a` and to `c`. By both sine and cosine: right to the last digits near 0 and 180. */
function angleAt(a: Vector, b: Vector, c: Vector): number {
  const [u, v] = [gap(b, a), gap(b, c)];
  const [p, q] = [Math.hypot(...u), Math.hypot(...v)];
  const [along, across] = [add(scale(u, q), scale(v, p)), minus(scale(u, q), scale(v, p))];
  return toDegrees(2 * Math.atan2(Math.hypot(...across), Math.hypot(...along)));
}

const scale = ([x, y, z]: Vector, by: number): Vector => [x * by, y * by, z * by];

/** Points at most: more were hardly chosen one after the other. */
const MOST_ON_A_WAY = 20;

function ofMany(points: readonly Vector[]): Measure[] {
  const extent = (axis: 0 | 1 | 2): [number, number] => {
    let [least, most] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
    for (const { [axis]: x } of points) [least, most] = [Math.min(least, x), Math.max(most, x)];
    return [least, most];
  };
  const [[x0, x1], [y0, y1], [z0, z1]] = [extent(0), extent(1), extent(2)];
  const steps = points.slice(1).map((point, k) => distance(points[k] ?? point, point));
  const total = steps.reduce((sum, step) => sum + step, 0);
  return [
    length("Lowest", z0),
    length("Highest", z1),
    length("Across x", x1 - x0),
    length("Across y", y1 - y0),
    length("Across z", z1 - z0),
    ...(points.length <= MOST_ON_A_WAY ? [length("Point to point", total)] : []),
  ];
}

/** Nothing of fewer than two points. */
export function measures(points: readonly Vector[]): readonly Measure[] {
  const [a, b, c] = points;
  if (!a || !b) return [];
  if (!c) return ofTwo(a, b);
  const angle = points.length === 3 ? [degrees("Angle at the second", angleAt(a, b, c))] : [];
  return [...angle, ...ofMany(points)];
}
