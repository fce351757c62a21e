// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { besideFinger, followed } from "../../web/src/features/touch/loupe.ts";

const WIDTH = 390;
/** Half of it, pixels; a finger covers about 25 around its middle. */
const [HALF, FINGER] = [56, 25];

it("lies clear of the finger and of the tools, inside the view, wherever the finger is", () => {
  for (let x = 0; x <= WIDTH; x += 13)
    for (let y = 0; y <= 600; y += 20) {
      const at = besideFinger({ x, y }, WIDTH);
      const gap = Math.hypot(at.x - x, at.y - y);
      expect(gap).toBeGreaterThan(HALF + FINGER);
      expect(at.x - HALF).toBeGreaterThanOrEqual(0);
      expect(at.x + HALF).toBeLessThanOrEqual(WIDTH);
      expect(at.y - HALF).toBeGreaterThanOrEqual(52);
    }
});

it("lies above the finger where there is room", () => {
  expect(besideFinger({ x: 200, y: 400 }, WIDTH)).toEqual({ x: 200, y: 300 });
});

it("shows the point that follows the finger, also where that has run away from it", () => {
  const finger = { x: 100, y: 100 };
  const near = { x: 110, y: 130 };
  expect(followed(finger, [{ x: 60, y: 100 }, near, { x: 300, y: 100 }])).toBe(near);
  // Held back: under the finger is the sky.
  const held = { x: 100, y: 370 };
  expect(followed(finger, [held])).toBe(held);
  expect(followed(finger, [])).toBeNull();
});
