// SPDX-License-Identifier: MIT
// How far the corners of panels are from the lines of their panel's sides. In a panel that is flat this is
// linear, so that what is between corners is interpolated exactly.

/** Where there is no side, or one whose line cuts through its panel: farther than any frame is wide. */
export const NO_SIDE = 1e3;

const MOST_SIDES = 8;

/** Distances kept of every corner: 4 where no panel has more sides, else 8; those beyond are left out. */
export function sidesKept(offsets: Int32Array): 4 | 8 {
  for (let f = 0; f + 1 < offsets.length; ++f)
    if ((offsets[f + 1] ?? 0) - (offsets[f] ?? 0) > 4) return MOST_SIDES;
  return 4;
}

/** Distances kept of the corners of all panels. */
export interface SideDistances {
  readonly array: Float32Array;
  /** How many belong to a corner. */
  readonly stride: number;
}

/** Of the panel that is written: kept between panels, since a drag writes thousands of them a frame. */
const normal = new Float64Array(3);
const inwards = new Float64Array(3);

const at = (of: ArrayLike<number>, k: number): number => of[k] ?? 0;

/** Into `normal`: the area vector, twice. */
function findNormal(corners: Float32Array, begin: number, end: number): void {
  normal.fill(0);
  for (let c = begin; c < end; ++c) {
    const next = c + 1 < end ? c + 1 : begin;
    for (let axis = 0; axis < 3; ++axis) {
      const [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
      const [fromI, fromJ] = [at(corners, 3 * begin + i), at(corners, 3 * begin + j)];
      const one = (at(corners, 3 * c + i) - fromI) * (at(corners, 3 * next + j) - fromJ);
      const other = (at(corners, 3 * c + j) - fromJ) * (at(corners, 3 * next + i) - fromI);
      normal[axis] = at(normal, axis) + one - other;
    }
  }
}

/** Into `inwards`: across the side from one corner to another, of length 1. */
function findInwards(corners: Float32Array, from: number, to: number): void {
  for (let axis = 0; axis < 3; ++axis) {
    const [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
    const alongI = at(corners, 3 * to + i) - at(corners, 3 * from + i);
    const alongJ = at(corners, 3 * to + j) - at(corners, 3 * from + j);
    inwards[axis] = at(normal, i) * alongJ - at(normal, j) * alongI;
  }
  const length = Math.hypot(at(inwards, 0), at(inwards, 1), at(inwards, 2)) || 1;
  for (let axis = 0; axis < 3; ++axis) inwards[axis] = at(inwards, axis) / length;
}

function writePanel(corners: Float32Array, begin: number, end: number, out: SideDistances): void {
  findNormal(corners, begin, end);
  for (let k = 0; k < Math.min(out.stride, end - begin); ++k) {
    const from = begin + k;
    findInwards(corners, from, from + 1 < end ? from + 1 : begin);
    let [least, most] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
    for (let c = begin; c < end; ++c) {
      let distance = 0;
      for (let axis = 0; axis < 3; ++axis)
        distance += (at(corners, 3 * c + axis) - at(corners, 3 * from + axis)) * at(inwards, axis);
      out.array[out.stride * c + k] = distance;
      least = Math.min(least, distance);
      most = Math.max(most, distance);
    }
    if (least >= -0.01 * most) continue;
    for (let c = begin; c < end; ++c) out.array[out.stride * c + k] = NO_SIDE;
  }
}

/** `corners` in the order of `offsets`. */
export function writeSideDistances(
  corners: Float32Array,
  offsets: Int32Array,
  out: SideDistances,
): void {
  out.array.fill(NO_SIDE);
  for (let f = 0; f + 1 < offsets.length; ++f)
    writePanel(corners, at(offsets, f), at(offsets, f + 1), out);
}

/**
 * Only of panels with a corner that is elsewhere in `before`, which becomes as `corners`.
 * @param wrote called with the first and last corner of each
 */
export function followCorners(
  corners: Float32Array,
  before: Float32Array,
  offsets: Int32Array,
  out: SideDistances,
  wrote: (corner: number) => void,
): void {
  for (let f = 0; f + 1 < offsets.length; ++f) {
    const [begin, end] = [at(offsets, f), at(offsets, f + 1)];
    let moved = false;
    for (let k = 3 * begin; k < 3 * end; ++k) {
      if (corners[k] === before[k]) continue;
      before[k] = at(corners, k);
      moved = true;
    }
    if (!moved) continue;
    writePanel(corners, begin, end, out);
    wrote(begin);
    wrote(end - 1);
  }
}

/** The mean length of the sides of panels. */
export function meanSide(corners: Float32Array, offsets: Int32Array): number {
  let sum = 0;
  for (let f = 0; f + 1 < offsets.length; ++f) {
    const [begin, end] = [offsets[f] ?? 0, offsets[f + 1] ?? 0];
    for (let k = begin; k < end; ++k) {
      const next = k + 1 < end ? k + 1 : begin;
      const along = (axis: number): number =>
        (corners[3 * next + axis] ?? 0) - (corners[3 * k + axis] ?? 0);
      sum += Math.hypot(along(0), along(1), along(2));
    }
  }
  return sum / Math.max(1, corners.length / 3);
}
