// SPDX-License-Identifier: MIT
import { STOPS, stopOf } from "./stops.ts";

const alike = (a: Float64Array, b: Float64Array): boolean =>
  a.length === b.length && a.every((x, k) => x === b[k]);

/** What each place of the slider showed last: two places may come to one mesh, as where panels of the nearest
 * flat mesh would lose their shape. */
export class ShownStops {
  readonly #positions = new Map<number, Float64Array>();

  /** The name of another place that showed the same points, to the last bit; null for none. */
  show(weight: number, positions: Float64Array): string | null {
    const stop = stopOf(weight);
    this.#positions.set(stop, positions);
    for (const [other, shown] of this.#positions)
      if (other !== stop && alike(shown, positions)) return STOPS[other]?.name ?? null;
    return null;
  }
}
