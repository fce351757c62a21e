// SPDX-License-Identifier: MIT
// Where what a model's own coordinates say stands on screen.

/** From model units into display coordinates: (p − centre) · scale. */
export interface Placing {
  readonly centre: readonly [number, number, number];
  readonly scale: number;
}

/** A coordinate along one axis. */
export const placedAlong = (axis: 0 | 1 | 2, at: number, { centre, scale }: Placing): number =>
  (at - centre[axis]) * scale;

/** x, y, z after x, y, z. A loop, since millions of calls would hold the page up. */
export function placed(coordinates: Float64Array, { centre, scale }: Placing): Float32Array {
  const display = new Float32Array(coordinates.length);
  for (let k = 0; k < coordinates.length; ++k)
    display[k] = ((coordinates[k] ?? 0) - (centre[k % 3] ?? 0)) * scale;
  return display;
}
