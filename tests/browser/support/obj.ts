// SPDX-License-Identifier: MIT
// An independent reading of exported OBJ files: shares no code with the product.
import { expect } from "vitest";

export interface ObjMesh {
  /** Coordinates as written, one line a vertex. */
  readonly lines: readonly string[];
  readonly points: readonly (readonly number[])[];
  readonly faces: readonly (readonly number[])[];
}

export function readObj(text: string): ObjMesh {
  const lines: string[] = [];
  const faces: number[][] = [];
  for (const line of text.split("\n")) {
    const [kind, ...words] = line.trim().split(/\s+/);
    if (kind === "v") lines.push(words.join(" "));
    if (kind === "f") faces.push(words.map((word) => Number.parseInt(word, 10) - 1));
  }
  return { lines, points: lines.map((line) => line.split(" ").map(Number)), faces };
}

type Vec = [number, number, number];

const subtract = (a: readonly number[], b: readonly number[]): Vec => [
  (a[0] ?? 0) - (b[0] ?? 0),
  (a[1] ?? 0) - (b[1] ?? 0),
  (a[2] ?? 0) - (b[2] ?? 0),
];
const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vec, b: Vec): Vec => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** Newell's normal of a polygon, unit length. */
function normalOf(points: readonly (readonly number[])[]): Vec {
  const origin = points[0] ?? [0, 0, 0];
  const arms = points.map((point) => subtract(point, origin));
  let normal: Vec = [0, 0, 0];
  for (const [k, arm] of arms.entries()) {
    const area = cross(arm, arms[(k + 1) % arms.length] ?? [0, 0, 0]);
    normal = [normal[0] + area[0], normal[1] + area[1], normal[2] + area[2]];
  }
  const length = Math.sqrt(dot(normal, normal));
  return [normal[0] / length, normal[1] / length, normal[2] / length];
}

/**
 * Flatness in mm/m of a polygon about the plane of its area vector (Newell's normal). For a nearly
 * flat polygon that plane and the best-fit one give the same figure to first order.
 */
export function flatness(points: readonly (readonly number[])[]): number {
  const normal = normalOf(points);
  const edges = points.map((point, k) => subtract(points[(k + 1) % points.length] ?? [], point));
  const longest = Math.max(...edges.map((edge) => Math.sqrt(dot(edge, edge))));
  const heights = points.map((point) => dot(subtract(point, points[0] ?? []), normal));
  return (1000 * (Math.max(...heights) - Math.min(...heights))) / longest;
}

export const worstFlatness = ({ points, faces }: ObjMesh): number =>
  Math.max(...faces.map((face) => flatness(face.map((v) => points[v] ?? []))));

/** Degrees between the normals of two panels along an edge, the largest. */
export function sharpestFold({ points, faces }: ObjMesh): number {
  const normals = faces.map((face) => normalOf(face.map((v) => points[v] ?? [])));
  const beside = new Map<string, Vec>();
  let least = 1;
  for (const [f, face] of faces.entries()) {
    const normal = normals[f] ?? [0, 0, 1];
    for (const [k, v] of face.entries()) {
      const next = face[(k + 1) % face.length] ?? v;
      const other = beside.get(`${next} ${v}`);
      if (other) least = Math.min(least, dot(normal, other));
      beside.set(`${v} ${next}`, normal);
    }
  }
  return (Math.acos(least) * 180) / Math.PI;
}

/** mm/m: what a finished edit promises. */
const TOLERANCE = 1e-6;

/** Everything flat, everything that is not counted as moved written with the same digits. */
export function expectLocalAndFlat(before: ObjMesh, after: ObjMesh, moved: number): void {
  expect(after.faces).toEqual(before.faces);
  expect(worstFlatness(after)).toBeLessThan(TOLERANCE);
  const differing = after.lines.filter((line, v) => line !== before.lines[v]).length;
  expect(differing).toBe(moved);
  expect(moved).toBeGreaterThan(0);
  expect(moved).toBeLessThan(before.lines.length / 2);
}
