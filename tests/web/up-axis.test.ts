// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { likelyUp, turnedObj } from "../../web/src/mesh/up-axis.ts";

const TEXT = "o roof\nv 1.25 -2 3e-05\nv 0 -0.1 7\nf 1 2 1\n";

it("turns keep every digit, and come back to the same file", () => {
  expect(turnedObj(TEXT, "z", "y")).toBe("o roof\nv 1.25 -3e-05 -2\nv 0 -7 -0.1\nf 1 2 1\n");
  expect(turnedObj(TEXT, "z", "x")).toBe("o roof\nv -2 3e-05 1.25\nv -0.1 7 0\nf 1 2 1\n");
  for (const from of ["x", "y", "z"] as const)
    for (const to of ["x", "y", "z"] as const)
      expect(turnedObj(turnedObj(turnedObj(TEXT, "z", from), from, to), to, "z")).toBe(TEXT);
});

it("a turn is no mirror: right hands stay right hands", () => {
  for (const up of ["x", "y", "z"] as const) {
    const turned = turnedObj("v 1 0 0\nv 0 1 0\nv 0 0 1\n", "z", up);
    const [a, b, c] = [...turned.matchAll(/v (\S+) (\S+) (\S+)/g)].map((m) =>
      m.slice(1).map(Number),
    ) as [number[], number[], number[]];
    const [ax = 0, ay = 0, az = 0] = a;
    const cross = [
      ay * (b[2] ?? 0) - az * (b[1] ?? 0),
      az * (b[0] ?? 0) - ax * (b[2] ?? 0),
      ax * (b[1] ?? 0) - ay * (b[0] ?? 0),
    ];
    expect(cross.map((part, k) => part - (c[k] ?? 0))).toEqual([0, 0, 0]);
    // What went up in the file goes up now.
    const axis = { x: a, y: b, z: c }[up];
    expect(axis).toEqual([0, 0, 1]);
  }
});

it("guesses what a roof has up, and nothing of a cube", () => {
  const square = (...positions: number[]) => ({
    positions: Float64Array.from(positions),
    offsets: Int32Array.of(0, 4),
    vertices: Int32Array.of(0, 1, 2, 3),
  });
  expect(likelyUp(square(0, 0, 0, 4, 0, 0, 4, 0, 4, 0, 0, 4))).toBe("y");
  expect(likelyUp(square(0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0))).toBe("z");
  expect(likelyUp(square(0, 0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4))).toBe("x");
  expect(likelyUp(square(0, 0, 0, 4, 0, 0, 4, 3, 3, 0, 3, 3))).toBeNull();
});
