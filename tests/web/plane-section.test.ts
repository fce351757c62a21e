// SPDX-License-Identifier: MIT
// Where a plane cuts panels.
import { expect, it } from "vitest";
import { cutAcross, section } from "../../web/src/features/section/section-plane.ts";
import { cutPanels, sectionLength } from "../../web/src/mesh/plane-section.ts";
import { setTarget } from "../../web/src/state/editing.ts";
import { sectionPlane } from "../../web/src/state/shown-section.ts";
import { openedPage } from "./support/page-here.ts";

/** A unit square, and a U of 3 × 2 whose notch is open at the top. */
const SQUARE = [0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1];
const U = [0, 0, 0, 3, 0, 0, 3, 0, 2, 2, 0, 2, 2, 0, 1, 1, 0, 1, 1, 0, 2, 0, 0, 2];
const panel = (corners: number) => ({
  offsets: Int32Array.of(0, corners),
  vertices: Int32Array.from({ length: corners }, (_, k) => k),
});

it("goes through a panel from side to side, and through both legs of one with a notch", () => {
  const half = cutPanels(SQUARE, panel(4), 2, 0.5);
  expect([...half.pieces].toSorted()).toEqual([0, 0, 0, 0.5, 0.5, 1]);
  expect(sectionLength(half)).toBe(1);
  expect(sectionLength(cutPanels(U, panel(8), 2, 0.5))).toBe(3);
  const legs = cutPanels(U, panel(8), 2, 1.5);
  expect([legs.panels, legs.pieces.length, sectionLength(legs)]).toEqual([1, 12, 2]);
  expect(cutPanels(SQUARE, panel(4), 2, 3)).toEqual({ pieces: new Float64Array(0), panels: 0 });
});

it("counts a corner on the plane once, and an edge in it with the panel below", () => {
  const two = {
    offsets: Int32Array.of(0, 4, 8),
    vertices: Int32Array.of(0, 1, 2, 3, 3, 2, 4, 5),
  };
  const points = [...SQUARE, 1, 0, 2, 0, 0, 2];
  const cut = cutPanels(points, two, 2, 1);
  expect([cut.panels, sectionLength(cut)]).toEqual([1, 1]);
});

it("follows the design, and goes through the point that is chosen", async () => {
  const page = await openedPage();
  cutAcross(page, 1);
  const before = section(page).value;
  expect(before?.panels).toBeGreaterThan(10);
  const p = page.mesh.value?.positions ?? new Float64Array(0);
  const middle = [p[660] ?? 0, p[661] ?? 0, p[662] ?? 0] as const;
  await setTarget(page, 220, [middle[0], middle[1], middle[2] + 0.5]);
  const after = section(page).value;
  expect(before && after && sectionLength(after) > sectionLength(before)).toBe(true);
  page.selection.value = [220];
  cutAcross(page, 0);
  expect(sectionPlane(page).value?.at).toBeCloseTo(middle[0], 1);
  cutAcross(page, null);
  expect(section(page).value).toBeNull();
});
