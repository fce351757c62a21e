// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import type { Design } from "../../web/src/design/design.ts";
import { FAIR_FLAT, type Trial } from "../../web/src/design/planarising.ts";
import { costWords } from "../../web/src/features/planarising/other-ways.tsx";
import {
  shapeOf,
  sharpestFold,
  usualFold,
} from "../../web/src/features/planarising/planarise-preview.ts";
import type { PlanariseTrials } from "../../web/src/features/planarising/planarise-trial.ts";
import { ShownStops } from "../../web/src/features/planarising/shown-stops.ts";
import { isFar } from "../../web/src/features/planarising/stops.ts";
import { TrialMemory } from "../../web/src/features/planarising/trial-memory.ts";
import { byCost, type OtherWay, WayCosts } from "../../web/src/features/planarising/way-costs.ts";
import type { OpenedMesh } from "../../web/src/solver/protocol.ts";

it("a place of the slider is the same as another that showed the same points, as they were last", () => {
  const stops = new ShownStops();
  const [one, other] = [Float64Array.from([0, 1, 2]), Float64Array.from([0, 1, 2.0000001])];
  expect(stops.show(10, one)).toBeNull();
  expect(stops.show(10, one)).toBeNull();
  expect(stops.show(0, other)).toBeNull();
  expect(stops.show(1, one.slice())).toBe("fair");
  expect(stops.show(0, one.slice())).toBe("fair");
  expect(stops.show(10, other)).toBeNull();
  expect(stops.show(0, Float64Array.from([0]))).toBeNull();
});

it("the shape of a trial holds the points that differ, to the last bit", () => {
  const base = Float64Array.from([0, 0, 0, 1, 1, 1, 2, 2, 2]);
  const now = Float64Array.from([0, 0, 0, 1, 1 + Number.EPSILON, 1, 2, 2, 3]);
  const { moved, positions } = shapeOf(now, base);
  expect([...moved]).toEqual([1, 2]);
  expect([...positions]).toEqual([1, 1 + Number.EPSILON, 1, 2, 2, 3]);
  expect(shapeOf(base, base).moved.length).toBe(0);
});

it("the usual fold is the 95th percentile of panels that have a neighbour", () => {
  const folds = Float32Array.from({ length: 100 }, (_, k) => 100 - k);
  expect(usualFold(folds)).toBe(95);
  expect(usualFold(Float32Array.from([-1, -1, 7]))).toBe(7);
  expect(usualFold(new Float32Array(0))).toBeNull();
});

it("the sharpest fold is of panels that have a neighbour, too", () => {
  expect(sharpestFold(Float32Array.from([3, -1, 79.5, 12]))).toBe(79.5);
  expect(sharpestFold(Float32Array.from([-1, 0]))).toBe(0);
  expect(sharpestFold(Float32Array.from([-1]))).toBeNull();
});

it("ways are sorted by how far points move, those that miss what they say and unknown ones last, refused ones left out", () => {
  const ways = ["unknown", "missed", "far", "near"].map((label) => ({
    label,
    how: FAIR_FLAT,
    share: 0,
  }));
  const cost = { met: true, move: 1, mmPerM: 0, bent: 0, split: 0 };
  const costs = new Map([
    ["far", { ...cost, move: 9 }],
    ["missed", { ...cost, met: false, move: 0.1 }],
    ["near", cost],
  ]);
  expect(byCost(ways, costs).map(({ label }) => label)).toEqual([
    "near",
    "far",
    "missed",
    "unknown",
  ]);
  expect(byCost(ways, new Map())).toEqual(ways);
  const refused = byCost(ways, new Map([...costs, ["far", null]]));
  expect(refused.map(({ label }) => label)).toEqual(["near", "missed", "unknown"]);
  expect(byCost(ways, new Map(ways.map(({ label }) => [label, null])))).toEqual(ways);
});

it("a way that what is near the file stands for does not do as it says", async () => {
  const trials = {
    end: () => undefined,
    run: async ({ how }: Pick<OtherWay, "how">) => {
      const report = { worstExcess: 1, worstMmPerM: 18, planarising: { largest: how.within || 9 } };
      return { mesh: { report }, measures: null, split: null, how } as unknown as Trial;
    },
  } as unknown as PlanariseTrials;
  const positions = Float64Array.from([0, 0, 0, 3, 20, 1]);
  const opened = { positions, report: { faces: 4 } } as unknown as OpenedMesh;
  const design = { settings: { tolerance: 1e-6, cuts: [] } } as unknown as Design;
  const free = { ...FAIR_FLAT, keepBoundary: false, within: 0, flat: 0 };
  const costs = new WayCosts(trials, opened, design);
  await costs.find([
    { label: "boundary", how: free, share: 0 },
    { label: "near", how: { ...free, within: 0.5 }, share: 0 },
  ]);
  const known = costs.now.value?.known;
  expect(known?.get("boundary")).toMatchObject({ met: false, mmPerM: 18 });
  expect(known?.get("boundary")?.move).toBeLessThan(9);
  expect(known?.get("near")).toMatchObject({ met: true, move: 0.5 });
});

it("a cost names the move, the panels that stay bent and those that are split", () => {
  const cost = { met: true, move: 0.033, mmPerM: 0, bent: 0, split: 0 };
  expect(costWords(cost, "m")).toBe("moves up to 33 mm, all flat");
  expect(costWords({ ...cost, mmPerM: 18.24, bent: 1, split: 64 }, "m")).toBe(
    "moves up to 33 mm, 1 panel bent by up to 18.2 mm/m, 64 panels split",
  );
});

it("what was tried is known again by its way and its splits, the newest of them", () => {
  const memory = new TrialMemory(2);
  const trial = {} as Trial;
  const way = (smooth: number) => ({ how: { ...FAIR_FLAT, smooth }, split: 0 });
  memory.keep(way(1), trial);
  expect(memory.find(way(1))).toBe(trial);
  expect(memory.find({ ...way(1), split: 3 })).toBeNull();
  memory.keep(way(2), trial);
  memory.keep(way(3), trial);
  expect(memory.find(way(1))).toBeNull();
  expect(memory.find(way(2))).toBe(trial);
});

it("a move is an alarm from 1 % of the longest side on", () => {
  const opened = { positions: Float64Array.from([0, 0, 0, 3, 20, 1]) };
  expect(isFar(0.199, opened)).toBe(false);
  expect(isFar(0.201, opened)).toBe(true);
});
