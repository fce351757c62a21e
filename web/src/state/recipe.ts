// SPDX-License-Identifier: MIT
// What makes a design again: its source and what was done to it, with a mark of the result.
import { crc32 } from "../share/crc32.ts";
import type { EditSettings, Planarising, Source } from "../solver/protocol.ts";
import type { Camera } from "./camera.ts";
import type { Design, Family, HandleRow } from "./design.ts";
import type { Unit } from "./units.ts";

/** Enough of a result to recognise it, or to say how far another one is from it. */
export interface ResultMark {
  /** CRC-32 of the moved indices and their coordinates, bit by bit. */
  readonly hash: number;
  readonly moved: number;
  /** A few moved vertices and where they went, model units: vertex, x, y, z for each. */
  readonly probes: readonly number[];
}

export interface Recipe {
  readonly source: Source;
  readonly planarised: Planarising | null;
  readonly handles: readonly HandleRow[];
  readonly settings: EditSettings;
  /** Families of variations, each around what the one before it gave; the last has the sliders. */
  readonly families: readonly Family[];
  readonly unit: Unit;
  readonly camera: Camera | null;
  readonly mark: ResultMark;
}

/** What is done again, whatever came out of it. */
export interface Steps extends Omit<Recipe, "mark"> {
  /** null: nothing was recorded to hold the result against. */
  readonly mark: ResultMark | null;
  /** Checksum of the base that was edited; null where it is not known. */
  readonly baseHash?: number | null;
  /** Sliders that are not named are at 0. */
  readonly someSliders?: boolean;
}

/** Vertices that are recorded to measure a deviation. */
const PROBES = 5;

const bytesOf = (array: Int32Array | Float64Array): Uint8Array =>
  new Uint8Array(array.buffer, array.byteOffset, array.byteLength);

export function markOf({ moved, positions }: Design["shape"]): ResultMark {
  const probes: number[] = [];
  const stride = Math.max(1, Math.floor(moved.length / PROBES));
  for (
    let k = Math.floor(stride / 2);
    k < moved.length && probes.length < 4 * PROBES;
    k += stride
  ) {
    const at = (axis: number) => Number((positions[3 * k + axis] ?? 0).toPrecision(12));
    probes.push(moved[k] ?? 0, at(0), at(1), at(2));
  }
  return { hash: crc32(bytesOf(positions), crc32(bytesOf(moved))), moved: moved.length, probes };
}

function familiesOf({ variation }: Design): Family[] {
  if (!variation) return [];
  const { coefficients, asked, eigenbasis, earlier } = variation;
  return [...earlier, { coefficients, asked, eigenbasis }];
}

export const recipeOf = (design: Design, unit: Unit, camera: Camera | null): Recipe => ({
  source: design.source,
  planarised: design.planarised,
  handles: design.handles,
  settings: design.settings,
  families: familiesOf(design),
  unit,
  camera,
  mark: markOf(design.shape),
});

/** Model units; 0 if the result is the recorded one to the last bit. */
export function deviation(mark: ResultMark, shape: Design["shape"], base: Float64Array): number {
  if (markOf(shape).hash === mark.hash) return 0;
  let largest = Number.EPSILON;
  for (let p = 0; p + 3 < mark.probes.length; p += 4) {
    const vertex = mark.probes[p] ?? 0;
    const k = shape.moved.indexOf(vertex);
    const from = k < 0 ? base.subarray(3 * vertex) : shape.positions.subarray(3 * k);
    const gap = (axis: number) => (from[axis] ?? 0) - (mark.probes[p + 1 + axis] ?? 0);
    largest = Math.max(largest, Math.hypot(gap(0), gap(1), gap(2)));
  }
  return largest;
}
