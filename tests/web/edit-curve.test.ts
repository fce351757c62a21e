// SPDX-License-Identifier: MIT
// In which ways an edit is asked for again, and which of the answers are worth choosing.
import { describe, expect, it } from "vitest";
import { type Design, FIRST_SETTINGS, NO_REPORT, NO_SHAPE } from "../../web/src/design/design.ts";
import {
  type CurvePoint,
  cutAgain,
  pointWords,
  waysOf,
  worthChoosing,
} from "../../web/src/features/few-panels/edit-curve.ts";

const design = (limits: readonly string[], growth = 0): Design => ({
  source: { kind: "sample", name: "vault", size: 21 },
  planarised: null,
  handles: [{ vertex: 7, target: [1, 0, 3], pinned: false }],
  settings: { ...FIRST_SETTINGS, limits, continuation: 8 },
  shape: NO_SHAPE,
  report: { ...NO_REPORT, sharpestFold: { before: 3, after: 3 + growth, growth } },
  variation: null,
});

const point = (label: string, panels: number, growth: number): CurvePoint => ({
  label,
  design: design([], growth),
  panels,
  minimal: null,
});

describe("the ways of an edit", () => {
  it("pull so that handles arrive, at once, within limits on folds from one to none", () => {
    const ways = waysOf(design(["fold=+10", "angle=30:150"]), [], 0);
    expect(ways.map(({ kind }) => kind)).toEqual(["edit", "edit", ...Array(4).fill("fewest")]);
    for (const { settings } of ways) {
      expect(settings.attraction).toBe(1e5);
      expect(settings.continuation).toBe(0);
      expect(settings.limits[0]).toBe("angle=30:150");
    }
    const folds = ways.map(({ settings }) => settings.limits[1] ?? "none");
    expect(folds.slice(2).sort()).toEqual(["fold=+15", "fold=+30", "fold=+8", "none"]);
    expect(ways[0]?.settings).toMatchObject({ softness: 0, locality: 1, smoothness: 1 });
    expect(ways[2]?.settings.softness).toBe(FIRST_SETTINGS.softness);
  });

  it("keep a limit on folds that someone stated", () => {
    const ways = waysOf(design(["fold=+10"]), ["fold=+10"], 0);
    expect(ways.map(({ kind }) => kind)).toEqual(["edit", "edit", "fewest"]);
    for (const { settings } of ways) expect(settings.limits).toEqual(["fold=+10"]);
  });

  it("are one where a number of panels is enough", () => {
    const ways = waysOf(design(["fold=+10", "angle=30:150"]), [], 60);
    expect(ways.map(({ label, most }) => [label, most])).toEqual([["At most 60 panels", 60]]);
    expect(ways[0]?.settings).toMatchObject({ attraction: 1e5, limits: ["angle=30:150"] });
  });
});

describe("points of the curve", () => {
  const [soft, sparse, close, loose, worse] = [
    point("as it is", 196, 33),
    point("sparse", 106, 69),
    point("close", 40, 8),
    point("loose", 30, 15),
    point("worse", 32, 20),
  ];

  it("are worth choosing where none has fewer panels and no sharper a fold", () => {
    const all = [soft, sparse, loose, worse, close].filter((one) => one !== undefined);
    expect(worthChoosing(all).map(({ label }) => label)).toEqual(["as it is", "close", "loose"]);
    expect(worthChoosing([])).toEqual([]);
  });

  it("say what they cost", () => {
    expect(pointWords(point("", 42, 8.2))).toBe("42 panels cut again, folds up to 8.2° sharper");
    expect(pointWords(point("", 1, 0))).toBe("1 panel cut again, folds up to 0° sharper");
  });

  it("count panels with a corner that moved, not those with a new bevel alone", () => {
    expect(cutAgain(Float32Array.of(0, 1, 90, 1, 0, 1, 90, 2, 0, 1, 90, 0, 0, 1, 90, 1))).toBe(2);
  });
});
