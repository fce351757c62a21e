// SPDX-License-Identifier: MIT
// Which axis of a file goes up, and what the mesh is with that as its third.
import type { Vector } from "./vector.ts";

/** Z: as the file has it. */
export type UpAxis = "z" | "y" | "x";

/** From the file's axes, counted from 1, less than 0 for the other way; the turn is none of a mirror. */
const TURNS: Readonly<Record<UpAxis, readonly [number, number, number]>> = {
  z: [1, 2, 3],
  y: [1, -3, 2],
  x: [2, 3, 1],
};

function negated(number: string): string {
  if (Number(number) === 0) return number;
  return number.startsWith("-") ? number.slice(1) : `-${number}`;
}

/** What has `from` up as `to` has it: for each axis then the one now, as in TURNS. */
const between = (from: UpAxis, to: UpAxis): readonly number[] =>
  TURNS[to].map((axis) => {
    const k = TURNS[from].findIndex((one) => Math.abs(one) === Math.abs(axis));
    return Math.sign(axis) * Math.sign(TURNS[from][k] ?? 0) * (k + 1);
  });

/** An OBJ that was turned for `from` turned for `to`: every number keeps its digits. */
export function turnedObj(text: string, from: UpAxis, to: UpAxis): string {
  const axes = between(from, to);
  return text.replace(/^v (\S+) (\S+) (\S+)/gm, (_, ...place: string[]) => {
    const part = (axis: number): string => place[Math.abs(axis) - 1] ?? "";
    return `v ${axes.map((axis) => (axis < 0 ? negated(part(axis)) : part(axis))).join(" ")}`;
  });
}

/** More of the panels than this must face along an axis before it is thought to go up. */
const MOST = 0.6;

interface Polygons {
  readonly positions: Float64Array;
  readonly offsets: Int32Array;
  readonly vertices: Int32Array;
}

/** The share of all area that faces along each axis, whichever way. */
function facing({ positions, offsets, vertices }: Polygons): Vector {
  const sum: [number, number, number] = [0, 0, 0];
  for (let f = 0; f + 1 < offsets.length; ++f) {
    const corners = vertices.subarray(offsets[f] ?? 0, offsets[f + 1] ?? 0);
    const at = (k: number, axis: number): number =>
      positions[3 * (corners[k % corners.length] ?? 0) + axis] ?? 0;
    for (const axis of [0, 1, 2] as const) {
      const [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
      let area = 0;
      for (let k = 1; k + 1 < corners.length; ++k) {
        area +=
          (at(k, a) - at(0, a)) * (at(k + 1, b) - at(0, b)) -
          (at(k, b) - at(0, b)) * (at(k + 1, a) - at(0, a));
      }
      sum[axis] += Math.abs(area);
    }
  }
  const all = sum[0] + sum[1] + sum[2];
  return [sum[0] / all, sum[1] / all, sum[2] / all];
}

/** The axis that a roof with these panels has up; null where none stands out. */
export function likelyUp(mesh: Polygons): UpAxis | null {
  const [x, y, z] = facing(mesh);
  if (z > MOST) return "z";
  if (y > MOST) return "y";
  return x > MOST ? "x" : null;
}
