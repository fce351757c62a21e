// SPDX-License-Identifier: MIT
// What is drawn around points on screen.
import { expect, it } from "vitest";
import { boundsOf, encloses } from "../../web/src/scene/area-picking.ts";
import { boxAround, extended } from "../../web/src/scene/outline.ts";

const loop = (...places: readonly (readonly [number, number])[]) =>
  places.map(([x, y]) => ({ x, y }));

const L = loop([0, 0], [40, 0], [40, 10], [10, 10], [10, 40], [0, 40]);

it("holds what it goes round, and not what lies in its bay", () => {
  for (const outline of [L, [...L].reverse()]) {
    expect(encloses(outline, { x: 5, y: 5 })).toBe(true);
    expect(encloses(outline, { x: 35, y: 5 })).toBe(true);
    expect(encloses(outline, { x: 5, y: 35 })).toBe(true);
    expect(encloses(outline, { x: 20, y: 20 })).toBe(false);
    expect(encloses(outline, { x: -1, y: 5 })).toBe(false);
  }
});

it("holds what it goes round twice", () => {
  const ring = loop([0, 0], [30, 0], [30, 30], [0, 30]);
  const twice = [...ring, ...loop([0, 0], [20, 0], [20, 20], [0, 20])];
  expect(encloses(twice, { x: 10, y: 10 })).toBe(true);
  expect(encloses(twice, { x: 25, y: 25 })).toBe(true);
});

it("holds nothing where it is no more than a line", () => {
  expect(encloses([], { x: 0, y: 0 })).toBe(false);
  expect(encloses(loop([0, 0], [10, 10]), { x: 5, y: 5 })).toBe(false);
});

it("is a box between two corners, whichever way it was drawn", () => {
  const box = boxAround({ x: 30, y: 8 }, { x: 10, y: 20 });
  expect(boundsOf(box)).toEqual({ left: 10, top: 8, right: 30, bottom: 20 });
  expect(encloses(box, { x: 20, y: 12 })).toBe(true);
  expect(encloses(box, { x: 20, y: 24 })).toBe(false);
});

it("goes on in steps that can be seen", () => {
  const begun = loop([0, 0]);
  expect(extended(begun, { x: 2, y: 2 })).toBe(begun);
  expect(extended(begun, { x: 4, y: 0 })).toEqual(loop([0, 0], [4, 0]));
});
