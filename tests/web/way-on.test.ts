// SPDX-License-Identifier: MIT
// Where a handle stops, in words, and what is offered to get further.
import { describe, expect, it } from "vitest";
import type { Design, Point } from "../../web/src/design/design.ts";
import {
  DEFAULT_SETTINGS,
  FIRST_SETTINGS,
  NO_REPORT,
  NO_SHAPE,
} from "../../web/src/design/design.ts";
import {
  byGain,
  gainWords,
  gotWords,
  reasonOf,
  reasonWords,
  sharedWords,
  stopOf,
  waysOn,
} from "../../web/src/features/stopping/way-on.ts";
import type { EditSettings, ShapeReport } from "../../web/src/solver/protocol.ts";

const base = (): Point => [1, 0, 0];
const row = { vertex: 7, target: [1, 0, 3] as Point, pinned: false };
const EDGE = 1;

type Way = ["fold" | "panels", number | null, "dragged" | "given" | "searched"];

const design = (settings: Partial<EditSettings>, report: Partial<ShapeReport> = {}): Design => ({
  source: { kind: "sample", name: "vault", size: 21 },
  planarised: null,
  handles: [row],
  settings: { ...FIRST_SETTINGS, ...settings },
  shape: NO_SHAPE,
  report: { ...NO_REPORT, movedVertices: 9, ...report },
  variation: null,
});

describe("where a handle stops", () => {
  it("is how much of its way it went, of the handle that is furthest from its target", () => {
    const other = { vertex: 8, target: [1, 0, 1] as Point, pinned: false };
    const at = (): Point => [1.5, 0, 2.16];
    const stop = stopOf([other, row], base, at, EDGE);
    expect(stop).toEqual({ vertex: 8, asked: 1, got: 2.16 });
    expect(stopOf([row], base, at, EDGE)).toEqual({ vertex: 7, asked: 3, got: 2.16 });
  });

  it("is no word where it is as good as there, or pinned", () => {
    expect(stopOf([row], base, () => [1, 0, 2.9], EDGE)).toBeNull();
    const short = { ...row, target: [1, 0, 0.05] as Point };
    expect(stopOf([short], base, () => [1, 0, 0.03], EDGE)).toBeNull();
    expect(stopOf([{ ...row, pinned: true }], base, base, EDGE)).toBeNull();
  });

  it("is said in one unit where one does", () => {
    expect(gotWords({ vertex: 7, asked: 0.3, got: 0.216 }, "m")).toBe("216 of 300 mm");
    expect(gotWords({ vertex: 7, asked: 30, got: 0.216 }, "m")).toBe("216 mm of 30.0 m");
  });
});

describe("what stops it", () => {
  const reason = (settings: Partial<EditSettings>, report: Partial<ShapeReport>) =>
    reasonOf(design(settings, report), false, null);

  it("is a stated limit only where one acts", () => {
    const limits = ["fold=25"];
    expect(reason({ limits }, { bounds: { fold: [3] } })).toBe("limits");
    expect(reason({ limits }, { bounds: { fold: [] } })).toBe("panels");
    const sliding = { bounds: { fold: [3], slide: [4] } };
    expect(reason({ limits: ["fold=25", "slide=0.1"] }, sliding)).toBe("slides");
    expect(reasonWords("slides", null)).toContain("joints would slide");
    expect(reason({}, { status: "infeasible_handles" })).toBe("panels");
    const keepOuts = ["above=3"];
    const held = { "keep-out": [212] };
    expect(reason({ keepOuts }, { bounds: held })).toBe("keep-outs");
    expect(reason({ keepOuts }, { bounds: { "keep-out": [] } })).toBe("panels");
    expect(reasonWords("keep-outs", null)).toBe(
      "Further, panels or points would enter a keep-out.",
    );
    const ways = waysOn(design({ keepOuts, clearance: 0.1 }), "keep-outs", null);
    expect(ways.map(({ change }) => change)).toEqual([{ keepOuts: [], clearance: 0 }]);
    expect(reasonWords("fold", 10)).toBe("Further, folds would be more than 10° sharper.");
    expect(reasonWords("limits", null)).toContain("would exceed a limit");
  });

  it("is not named where no panel is at a limit and yet it was not followed further", () => {
    const refused = { status: "infeasible_handles", bounds: { fold: [] } } as const;
    expect(reason({ limits: ["fold=25"] }, refused)).toBe("unknown");
    const held = (limits: string[], growth: number | null) =>
      reasonOf(design({ limits }, { bounds: { fold: [] } }), true, growth);
    expect(held(["fold=+10"], 10)).toBe("unknown");
    expect(held(["area=2"], null)).toBe("unknown");
    // After a search that nothing bounds.
    expect(held([], null)).toBe("panels");
    expect(reasonWords("unknown", 10, "dragged")).toBe(
      "The drag found no way further; another solve may.",
    );
    for (const sought of ["given", "searched"] as const) {
      expect(reasonWords("unknown", 10, sought)).toBe(
        "No panel is at a limit, but it was not followed further.",
      );
    }
    const labels = (growth: number | null) =>
      waysOn(design({ limits: ["area=2"] }), "unknown", growth).map(({ label }) => label);
    expect(labels(null)).toContain("Without limits");
    expect(labels(10)).toContain("Softer");
  });

  it("is the drag's own limit only where folds are at it, and no other limit is in their place", () => {
    const held = (bounds: Record<string, number[]>, growth: number | null) =>
      reasonOf(design({ limits: ["area=2", "fold=+10"] }, { bounds }), true, growth);
    expect(held({ area: [], fold: [3] }, 10)).toBe("fold");
    expect(held({ area: [3], fold: [] }, 10)).toBe("limits");
    expect(held({ area: [], fold: [3] }, null)).toBe("limits");
  });
});

describe("ways on", () => {
  const labels = (d: Design, ...why: ["fold" | "limits" | "panels", number | null]): string[] =>
    waysOn(d, ...why).map(({ label }) => label);
  const fold = { sharpestFold: { before: 5.7, after: 15 } };

  it("past a drag's own limit keep it, but for the one that loosens it", () => {
    const ways = waysOn(design({}, fold), "fold", 10);
    expect(ways.map(({ label, growth }) => [label, growth])).toEqual([
      ["Reach 9 panels", 10],
      ["Softer", 10],
      ["Folds up to 26°", 20],
      ["Let the boundary move", 10],
      ["Meet it exactly", null],
    ]);
    expect(ways.map(({ change }) => change)).toEqual([
      { reach: 9, reachLength: 0 },
      { softness: 7 },
      {},
      { keepBoundary: false },
      { hardHandles: true },
    ]);
  });

  it("past a stated limit loosen it, and other limits stay", () => {
    const limits = ["fold=25", "angle=40:140"];
    const loose = waysOn(design({ limits }), "limits", null).find(({ label }) =>
      label.startsWith("F"),
    );
    expect(loose?.label).toBe("Folds up to 35°");
    expect(loose?.change).toEqual({ limits: ["fold=35", "angle=40:140"] });
    expect(labels(design({ limits: ["fold=+5"] }), "limits", null)).toContain(
      "Folds sharper by 15°",
    );
    expect(labels(design({ limits: ["area=2"] }), "limits", null)).toContain("Without limits");
  });

  it("past the limit on slides loosen that alone", () => {
    const limits = ["fold=25", "slide=0.1"];
    const ways = waysOn(design({ limits }), "slides", null);
    const further = ways.find(({ label }) => label === "Joints slide twice as far");
    expect(further?.change).toEqual({ limits: ["fold=25", "slide=0.2"] });
    expect(ways.some(({ label }) => /Folds|Without/.test(label))).toBe(false);
  });

  it("begin with a search towards the target, within the limit that held a drag or as stated limits let it", () => {
    const first = (...[reason, growth, sought]: Way) =>
      waysOn(design({}), reason, growth, sought)[0];
    const searched = first("panels", null, "given");
    expect(searched?.label).toBe("As far as it goes");
    expect([searched?.change, searched?.growth]).toEqual([{}, Number.POSITIVE_INFINITY]);
    const within = first("fold", 10, "dragged");
    expect([within?.label, within?.growth]).toEqual(["Within the limit", 10]);
    expect(first("panels", null, "searched")?.label).toBe("Reach 9 panels");
  });

  it("are only those that are not taken yet", () => {
    expect(labels(design({ reach: 12, softness: 10 }, fold), "fold", 10)).toEqual([
      "Reach without limit",
      "Folds up to 26°",
      "Let the boundary move",
      "Meet it exactly",
    ]);
    const all = { ...DEFAULT_SETTINGS, hardHandles: true };
    expect(labels(design(all), "panels", null)).toEqual([]);
  });
});

describe("what a way on gains", () => {
  const before = { vertex: 7, asked: 3, got: 1 };

  it("is how far it gets and how it folds there, or that it is no more than before", () => {
    expect(gainWords({ got: 2.168, fold: 15.6, spoilt: 0, damage: "" }, before, "m")).toBe(
      "2168 mm, 16°",
    );
    expect(gainWords({ got: null, fold: 46, spoilt: 0, damage: "" }, before, "m")).toBe(
      "all the way, 46°",
    );
    expect(gainWords({ got: 1.009, fold: 8, spoilt: 0, damage: "" }, before, "m")).toBe(
      "no further",
    );
    expect(gainWords({ got: 0, fold: null, spoilt: 0, damage: "" }, before, "m")).toBe(
      "no further",
    );
  });

  it("is in the sentence of a drag that was held back, where its limit lets other panels share the bend", () => {
    const shared = (got: number | null): string =>
      sharedWords(
        new Map([["Within the limit", { got, fold: 16, spoilt: 0, damage: "" }]]),
        before,
        "m",
      );
    expect(shared(3.333)).toBe(", 3333 mm sharing the bend");
    expect(shared(null)).toBe(", all the way sharing the bend");
    expect(shared(1.009)).toBe("");
    expect(sharedWords(new Map(), before, "m")).toBe("");
  });

  it("sorts those that gain: all the way first, there the least fold, and what is not known last", () => {
    const way = (label: string) => ({ label, title: "", change: {}, growth: null });
    const gains = new Map([
      ["a", { got: 1.2, fold: 9, spoilt: 0, damage: "" }],
      ["c", { got: null, fold: 40, spoilt: 0, damage: "" }],
      ["d", { got: null, fold: 16, spoilt: 0, damage: "" }],
      ["e", { got: 2, fold: 20, spoilt: 0, damage: "" }],
      ["f", { got: 1, fold: 5, spoilt: 0, damage: "" }],
      ["g", { got: null, fold: 9, spoilt: 2, damage: "2 panels became slivers" }],
    ]);
    const sorted = (labels: string): string[] =>
      byGain([...labels].map(way), gains, before).map(({ label }) => label);
    expect(sorted("gabcdef")).toEqual(["d", "c", "g", "e", "a", "b"]); // as far, but spoilt: behind
    expect(sorted("f")).toEqual(["f"]); // where nothing helps, what there is
  });
});
