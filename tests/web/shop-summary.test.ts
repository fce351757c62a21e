// SPDX-License-Identifier: MIT
// What a cutting package holds, in a sentence: nothing that is missing or in pieces goes unsaid.
import { expect, it } from "vitest";
import { summary } from "../../web/src/features/shop/shop-summary.ts";

const plain = {
  counts: { panels: 12, drawn: 12 },
  remake: null,
  flatness_mm_per_m: 0,
  excess_mm_per_m: 0,
  vanished: [],
};

it("says no more than what is drawn where nothing is wrong", () => {
  expect(summary(plain)).toBe("12 panels drawn.");
  expect(summary({ ...plain, apart: [], lost_sides: [] })).toBe("12 panels drawn.");
});

it("names panels that the joint cuts into pieces, takes sides of, or leaves nothing of", () => {
  const header = {
    ...plain,
    counts: { panels: 12, drawn: 11 },
    vanished: ["P9"],
    apart: [{ panel: "P3", pieces: 2 }],
    lost_sides: ["P4", "P5"],
  };
  expect(summary(header)).toBe(
    "11 panels drawn; not drawn, as nothing is left of them or they cross themselves: P9; " +
      "the joint cuts into pieces: P3 (2 pieces); the joint takes whole sides of P4, P5.",
  );
});

it("counts sheets and what is larger than one, and says how far from flat", () => {
  const sheets = { count: 1, used_fraction: 0.62, oversize: ["P1"] };
  expect(summary({ ...plain, sheets, labels: { link: "https://…", code: false } })).toBe(
    "12 panels drawn; 1 sheet, 62 % used; 1 panel larger than a sheet; " +
      "the labels carry no QR code, as the link is too long for one.",
  );
  expect(summary({ ...plain, flatness_mm_per_m: 2.5, excess_mm_per_m: 2.5 })).toContain(
    "not flat: a panel is out of its plane by 2.5",
  );
});
