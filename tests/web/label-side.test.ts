// SPDX-License-Identifier: MIT
// The figure of a point covers no other mark where a side is free.
import { expect, it } from "vitest";
import { sideOf } from "../../web/src/scene/label-side.ts";

const view = { width: 800, height: 600 };
const at = { x: 400, y: 300 };
const [left, right, below, above] = [
  { x: 360, y: 305 },
  { x: 440, y: 305 },
  { x: 410, y: 330 },
  { x: 410, y: 270 },
];

it("left, or the next side where no mark is", () => {
  expect(sideOf(at, [], view)).toBe("left");
  expect(sideOf(at, [right, below, above], view)).toBe("left");
  expect(sideOf(at, [left], view)).toBe("right");
  expect(sideOf(at, [left, right], view)).toBe("below");
  expect(sideOf(at, [left, right, below], view)).toBe("above");
  expect(sideOf(at, [left, right, below, above], view)).toBe("left");
});

it("within the view", () => {
  expect(sideOf({ x: 50, y: 300 }, [], view)).toBe("right");
  expect(sideOf({ x: 50, y: 300 }, [{ x: 90, y: 305 }], view)).toBe("right");
  expect(sideOf({ x: 400, y: 590 }, [{ x: 360, y: 590 }], view)).toBe("above");
  expect(sideOf({ x: 95, y: 300 }, [], { width: 190, height: 600 })).toBe("below");
});
