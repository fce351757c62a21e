// SPDX-License-Identifier: MIT
// Mirror planes and turns of a mesh, under which an edit of one point edits its images.
import type { EditSettings, Symmetry } from "../solver/protocol.ts";
import type { HandleRow } from "./design.ts";

export interface Mirrors {
  /** Of x, y, z: mirrored across it. */
  readonly across: readonly boolean[];
  /** About each of x, y, z; 0 for none. */
  readonly turns: readonly number[];
}

const AXES = ["x", "y", "z"] as const;

/** A symmetry as controls show it. */
export function mirrorsIn(symmetry: readonly string[]): Mirrors {
  const turnsAbout = (axis: string): number => {
    const found = symmetry.find((one) => one.startsWith(`axis:${axis}:`));
    return found ? Number(found.slice("axis:x:".length)) : 0;
  };
  return { across: AXES.map((axis) => symmetry.includes(axis)), turns: AXES.map(turnsAbout) };
}

/** Mirrors first, so that the same symmetry is the same design. */
export const mirrorsText = ({ across, turns }: Mirrors): readonly string[] => [
  ...AXES.filter((_, k) => across[k]),
  ...AXES.flatMap((axis, k) => {
    const count = turns[k] ?? 0;
    return count > 0 ? [`axis:${axis}:${count}`] : [];
  }),
];

/** What the base of an edit with these settings has to have; null for nothing. */
export const symmetryIn = ({ symmetry, tolerance }: EditSettings): Symmetry | null =>
  symmetry.length > 0 ? { elements: symmetry, tolerance } : null;

export const sameSymmetry = (a: Symmetry | null, b: Symmetry | null): boolean =>
  a?.tolerance === b?.tolerance && a?.elements.join() === b?.elements.join();

/** The points that follow `vertices`. @param orbits see MeshSymmetry */
export function imagesOf(orbits: Int32Array, vertices: readonly number[]): number[] {
  const chosen = new Set(vertices.map((vertex) => orbits[vertex]));
  const images: number[] = [];
  orbits.forEach((orbit, vertex) => {
    if (chosen.has(orbit) && !vertices.includes(vertex)) images.push(vertex);
  });
  return images;
}

/**
 * `rows` without those that are images of a row that is not in `before`: the younger one says where both
 * go. @param orbits see MeshSymmetry
 */
export function withoutImages(
  orbits: Int32Array,
  before: readonly HandleRow[],
  rows: readonly HandleRow[],
): HandleRow[] {
  const speaker = new Map<number, number>();
  for (const row of rows) {
    const orbit = orbits[row.vertex] ?? row.vertex;
    if (!before.includes(row)) speaker.set(orbit, row.vertex);
  }
  return rows.filter(({ vertex }) => {
    const said = speaker.get(orbits[vertex] ?? vertex);
    return said === undefined || said === vertex;
  });
}
