// SPDX-License-Identifier: MIT
// What the sliders of a family do, and where they stop.
import type { ShapeFamily } from "./analysis.ts";
import type { SliderLead, SliderRange } from "./protocol.ts";

/** Of a slider's longest move: less is no move. */
const STILL = 1e-6;

export function leadsOf({ support, moves }: ShapeFamily): SliderLead[] {
  const stride = 3 * support.length;
  const count = stride > 0 ? moves.length / stride : 0;
  return Array.from({ length: count }, (_, slider) => {
    const own = moves.subarray(slider * stride, (slider + 1) * stride);
    const lengths = Array.from(support, (_v, k) => Math.hypot(...own.subarray(3 * k, 3 * k + 3)));
    const longest = lengths.reduce((most, length) => Math.max(most, length), 0);
    const k = lengths.indexOf(longest);
    const [x = 0, y = 0, z = 0] = own.subarray(3 * k, 3 * k + 3);
    const points = lengths.filter((length) => length > STILL * longest).length;
    return { vertex: support[k] ?? 0, move: [x, y, z], points };
  });
}

/** `stops`: lower, its panel, upper, its panel of each slider. */
export const rangesOf = (stops: Float64Array): SliderRange[] =>
  Array.from({ length: stops.length / 4 }, (_, k) => {
    const [lower = 0, lowerPanel = -1, upper = 0, upperPanel = -1] = stops.subarray(4 * k);
    return { lower, lowerPanel, upper, upperPanel };
  });
