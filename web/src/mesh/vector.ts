// SPDX-License-Identifier: MIT
// Vectors of three numbers: points, and ways between them.

export type Vector = readonly [number, number, number];

export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

export const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** `a` + `t` · `b`. */
export const add = (a: Vector, b: Vector, t = 1): Vector => [
  a[0] + t * b[0],
  a[1] + t * b[1],
  a[2] + t * b[2],
];

export const minus = (a: Vector, b: Vector): Vector => add(a, b, -1);
