// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { worstOfPoints } from "../../web/src/state/measured-panels.ts";

it("gives each panel the worst of its points, and -1 where none is bound", () => {
  const faces = { offsets: Int32Array.of(0, 3, 7), vertices: Int32Array.of(0, 1, 2, 2, 1, 3, 4) };
  const defects = Float32Array.of(-1, -1, -1, 0.5, 0.25);
  expect([...worstOfPoints(defects, faces)]).toEqual([-1, 0.5]);
  expect([...worstOfPoints(Float32Array.of(0, 2, 1, 0, 0), faces)]).toEqual([2, 2]);
});
