// SPDX-License-Identifier: MIT
import { Color } from "three";

/** Linear-light colour stops, blended in between. */
export type Ramp = readonly Color[];

export const makeRamp = (stops: readonly string[]): Ramp => stops.map((stop) => new Color(stop));

/** Writes the ramp's colour at `t` in 0 … 1 to `out` at `offset`. */
export function writeRamp(ramp: Ramp, t: number, out: Float32Array, offset: number): void {
  const place = Math.min(Math.max(t, 0), 1) * (ramp.length - 1);
  const k = Math.min(Math.floor(place), ramp.length - 2);
  const a = ramp[k];
  const b = ramp[k + 1];
  if (!a || !b) return;
  const mix = place - k;
  out[offset] = a.r + (b.r - a.r) * mix;
  out[offset + 1] = a.g + (b.g - a.g) * mix;
  out[offset + 2] = a.b + (b.b - a.b) * mix;
}

/** Place on the ramp by the core's PanelChange: unchanged, cut again at the end, a new bevel between. */
export const remakePlace = (change: number): number => [0, 1, 0.5][change] ?? 0;

/** A ramp for a legend. */
export const cssGradient = (stops: readonly string[]): string =>
  `linear-gradient(to right in oklab, ${stops.join(", ")})`;
