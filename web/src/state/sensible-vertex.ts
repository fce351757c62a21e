// SPDX-License-Identifier: MIT
/** Points that are asked whether they can be seen, before the best one stands all the same. */
const TRIES = 64;

/**
 * A vertex worth moving when the user has named none: inside the shell, in the middle of it at
 * first, then as far as possible from the handles that are there; of two skins that of the one before.
 */
export function sensibleVertex(
  positions: ArrayLike<number>,
  boundary: Uint8Array,
  handles: readonly number[],
  isSeen: (vertex: number) => boolean = () => true,
): number | null {
  const count = Math.floor(positions.length / 3);
  const at = (v: number, axis: number): number => positions[3 * v + axis] ?? 0;
  const distance = (v: number, to: readonly number[]): number =>
    Math.hypot(...to.map((x, axis) => at(v, axis) - x));
  const anyInside = boundary.includes(0);
  const middle = [0, 1].map((axis) => {
    let sum = 0;
    for (let v = 0; v < count; ++v) sum += at(v, axis);
    return sum / count;
  });
  const places = handles.map((v) => [at(v, 0), at(v, 1), at(v, 2)]);
  const merit = (v: number): number =>
    places.length === 0
      ? -distance(v, middle)
      : Math.min(...places.map((place) => distance(v, place))) - 0.5 * distance(v, middle);
  const hidden = new Set<number>();
  const next = (): number | null => {
    let best: number | null = null;
    let highest = Number.NEGATIVE_INFINITY;
    for (let v = 0; v < count; ++v) {
      if ((anyInside && boundary[v] === 1) || handles.includes(v) || hidden.has(v)) continue;
      const value = merit(v);
      if (value > highest) {
        highest = value;
        best = v;
      }
    }
    return best;
  };
  const best = next();
  for (let v = best; v !== null && hidden.size < TRIES; v = next()) {
    if (isSeen(v)) return v;
    hidden.add(v);
  }
  return best;
}
