// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import { NO_SHAPE } from "../../web/src/design/design.ts";
import { stopsWithin, wayWords, within } from "../../web/src/features/exploring/slider-range.ts";
import { leadsOf, rangesOf } from "../../web/src/solver/sliders.ts";

describe("a slider", () => {
  it("leads where it moves most", () => {
    const support = Int32Array.of(3, 8);
    const moves = Float64Array.of(0, 0, 1, 0, 3, 4, 2, 0, 0, 0, 0, 0);
    expect(leadsOf({ centre: NO_SHAPE, support, moves })).toEqual([
      { vertex: 8, move: [0, 3, 4], points: 2 },
      { vertex: 3, move: [2, 0, 0], points: 1 },
    ]);
  });

  it("says which way, by the surface", () => {
    expect(wayWords([0, 0, 2], [0, 0, 1])).toBe("out of the surface");
    expect(wayWords([0, 0.1, -2], [0, 0, 1])).toBe("into the surface");
    expect(wayWords([1, 0, 0.1], [0, 0, 1])).toBe("along the surface");
    expect(wayWords([1, 0, 0.6], [0, 0, 1])).toBe("out of the surface and along it");
  });

  it("stops only within what it shows", () => {
    const [range] = rangesOf(Float64Array.of(-0.4, 7, Number.POSITIVE_INFINITY, -1));
    expect(range && stopsWithin(range, 1)).toEqual([-0.4, null]);
    expect(range && within([-0.7], [range])[0]).toBeCloseTo(-0.36, 12);
    expect(range && within([0.7], [range])).toEqual([0.7]);
  });
});
