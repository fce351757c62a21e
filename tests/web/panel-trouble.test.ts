// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { TROUBLES, troublesOf, urgencyOf } from "../../web/src/state/panel-trouble.ts";

const words = (troubles: Float32Array): readonly (string | undefined)[] =>
  [...troubles].map((place) => TROUBLES[place]);

it("a panel has the worst of what is true of it", () => {
  // Outline, shortest edge, smallest angle, change.
  const panels = [
    [0, 1, 80, 0],
    [0, 1, 14.9, 0],
    [1, 1, 10, 0],
    [0, 0, 0, 1],
    [1, 1, 80, 1],
    [2, 1, 80, 1],
  ];
  const damage = Uint8Array.of(0, 0, 4, 3, 2, 1);
  expect(words(troublesOf(Float32Array.from(panels.flat()), damage))).toEqual([...TROUBLES]);
});

it("what is not flat is looked at first, then the class, then the fold", () => {
  const troubles = Float32Array.of(0, 0, 5, 1, 0);
  const figures = Float32Array.from([0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 20, 20]);
  const urgency = urgencyOf(troubles, figures, Float32Array.of(3, 90, 1, 2, 0));
  const order = [...urgency.keys()].sort((a, b) => (urgency[b] ?? 0) - (urgency[a] ?? 0));
  expect(order).toEqual([4, 2, 3, 1, 0]);
});
