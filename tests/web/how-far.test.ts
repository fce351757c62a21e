// SPDX-License-Identifier: MIT
// How far along a pull an edit gets: the largest share whose target its handles meet.
import { expect, it } from "vitest";
import { furthest, MET } from "../../web/src/solver/how-far.ts";

/** Handles that get to where `reach` says of a share, and what was asked of them. */
function pulled(reach: (share: number) => number, tries?: number) {
  const tried: number[] = [];
  let [last, kept] = [Number.NaN, Number.NaN];
  const puller = {
    edit: (at: number) => {
      tried.push(at);
      last = at;
      const short = at - reach(at);
      return { short, over: short - MET * at };
    },
    keep: () => {
      kept = last;
    },
    back: () => {
      last = kept;
    },
  };
  const share = furthest(puller, tries);
  return { share, tried, shown: last };
}

it("takes a pull that is met as it is, in one edit", () => {
  expect(pulled((at) => 0.96 * at)).toEqual({ share: 1, tried: [1], shown: 1 });
});

it.each([0.9, 0.5, 0.25, 0.1])("ends about as far as handles get, and shows that: %d", (most) => {
  const reach = (at: number): number => Math.min(0.98 * at, most);
  const { share, tried, shown } = pulled(reach);
  expect(share).toBeLessThanOrEqual(most / (1 - MET));
  expect(reach(share)).toBeGreaterThan(0.97 * most);
  expect(shown).toBe(share);
  expect(tried.length).toBeLessThanOrEqual(6);
});

it("goes on from where a far target got less far than one that is met", () => {
  const { share, shown } = pulled((at) => (at > 0.7 ? 0.3 : at));
  expect(share).toBeGreaterThan(0.65);
  expect(share).toBeLessThanOrEqual(0.7);
  expect(shown).toBe(share);
});

it("ends at the smallest that was tried where none is met", () => {
  const { share, tried, shown } = pulled(() => 0);
  expect(share).toBe(Math.min(...tried));
  expect(shown).toBe(share);
  expect(share).toBeLessThan(0.05);
});

it("keeps what nearly met its target where all that does gets much less far", () => {
  const { share, shown } = pulled((at) => (at === 1 ? 0.94 : 0.3 * at));
  expect(share).toBe(1);
  expect(shown).toBe(1);
});

it("ends about as far by a far target as by a near one where more edits may be made", () => {
  // Of what is met, 1 unit at most, a target that is not says little.
  const far = (length: number) => (at: number) => Math.min(at, at * length > 1 ? 0.2 / length : at);
  const ends = [2, 15].map((length) => pulled(far(length), 8).share * length);
  expect(Math.min(...ends)).toBeGreaterThan(0.9);
  expect(Math.max(...ends)).toBeLessThanOrEqual(1);
  expect(pulled(far(15)).share * 15).toBeLessThan(0.9);
});
