// SPDX-License-Identifier: MIT
// Panel edges and untouched panels must be told apart from every colour of every map, by
// lightness alone: for any kind of colour vision, on paper and on a projector.
import { describe, expect, it } from "vitest";
import { INK } from "../../web/src/scene/edge-lines.ts";
import { DARK, LIGHT } from "../../web/src/scene/palette.ts";

/** WCAG's relative luminance of an sRGB colour, channels in 0 … 255. */
function luminance(channels: readonly number[]): number {
  const [r = 0, g = 0, b = 0] = channels.map((c) =>
    c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4,
  );
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

const channels = (hex: string): number[] =>
  [1, 3, 5].map((k) => Number.parseInt(hex.slice(k, k + 2), 16));

function contrast(a: readonly number[], b: readonly number[]): number {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return ((high ?? 0) + 0.05) / ((low ?? 0) + 0.05);
}

describe.each([
  ["light", LIGHT],
  ["dark", DARK],
])("on a %s page", (_, palette) => {
  const stops = [...palette.displacement, ...palette.lowered, ...palette.planarity];

  it("edges show on every colour of every map", () => {
    const edge = channels(palette.edge);
    for (const stop of stops) {
      const panel = channels(stop);
      const line = panel.map((c, k) => c * (1 - INK) + (edge[k] ?? 0) * INK);
      expect(contrast(panel, line), stop).toBeGreaterThan(2);
    }
  });

  it("each map gets darker all the way, well apart from an untouched panel at its end", () => {
    for (const ramp of [palette.displacement, palette.lowered, palette.planarity]) {
      const lights = ramp.map((stop) => luminance(channels(stop)));
      expect(lights).toEqual([...lights].sort((x, y) => y - x));
      const [first = "", last = ""] = [ramp[0], ramp.at(-1)];
      expect(contrast(channels(first), channels(last)), last).toBeGreaterThan(1.5);
    }
  });

  it("a panel shows on the page", () => {
    const panel = channels(palette.panel);
    expect(palette.displacement[0]).toBe(palette.panel);
    expect(palette.lowered[0]).toBe(palette.panel);
    expect(palette.planarity[0]).toBe(palette.panel);
    if (palette === DARK) expect(contrast(panel, channels(palette.paper))).toBeGreaterThan(3);
  });
});
