// SPDX-License-Identifier: MIT
import { Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { facing, outwards } from "../../web/src/scene/panel-look.ts";

/** A square that faces +z. */
const SQUARE = Float32Array.from([0, 0, 2, 1, 0, 2, 1, 1, 2, 0, 1, 2]);
const UP = new Vector3(0, 0, 1);

const at = (degrees: number): Vector3 => {
  const angle = (degrees * Math.PI) / 180;
  return new Vector3(Math.sin(angle), 0, Math.cos(angle));
};

const degreesTo = (a: Vector3, b: Vector3): number => (a.angleTo(b) * 180) / Math.PI;

describe("the direction that shows a panel", () => {
  it.each([0, 40, 74])("stays where the panel is seen well: at %d°", (angle) => {
    expect(facing(SQUARE, at(angle), 0)).toEqual(at(angle));
    expect(facing(SQUARE, at(angle), 1)).toEqual(at(angle));
  });

  it("turns the least way from a grazing view, on the side it is on", () => {
    const over = facing(SQUARE, at(80), 0);
    expect(degreesTo(over, UP)).toBeCloseTo(45, 6);
    expect(degreesTo(over, at(80))).toBeCloseTo(35, 6);
    expect(degreesTo(facing(SQUARE, at(100), 0), UP)).toBeCloseTo(135, 6);
  });

  it("of an open model may be from either side, of a closed one from outside", () => {
    expect(facing(SQUARE, at(180 - 30), 0)).toEqual(at(180 - 30));
    expect(degreesTo(facing(SQUARE, at(180 - 30), 1), UP)).toBeCloseTo(45, 6);
    expect(degreesTo(facing(SQUARE, at(30), -1), UP)).toBeCloseTo(135, 6);
    for (const angle of [0, 180])
      expect(
        degreesTo(facing(SQUARE, at(180 - angle), angle === 0 ? 1 : -1), at(angle)),
      ).toBeCloseTo(45, 6);
  });

  it("stays for a panel without an area", () => {
    expect(facing(new Float32Array(12), at(80), 0)).toEqual(at(80));
  });
});

it("knows which way the panels of a closed model face", () => {
  // A tetrahedron about the origin.
  const corners = Float32Array.from([1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1]);
  const out = Uint32Array.from([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]);
  const inside = new Uint8Array(4);
  const sign = outwards(corners, out, inside);
  expect(Math.abs(sign)).toBe(1);
  expect(outwards(corners, out.slice().reverse(), inside)).toBe(-sign);
  const [a, b, c] = [0, 2, 1].map((v) => new Vector3().fromArray(corners, 3 * v));
  if (!a || !b || !c) throw new Error("no triangle");
  const normal = b.clone().sub(a).cross(c.clone().sub(a));
  expect(Math.sign(normal.dot(a))).toBe(sign);
  expect(outwards(corners, out, Uint8Array.from([0, 1, 0, 0]))).toBe(0);
});
