// SPDX-License-Identifier: MIT
// What "Fit the selection" brings into view.
import { expect, it } from "vitest";
import { buildTopology } from "../../web/src/mesh/topology.ts";
import { chosenOf } from "../../web/src/scene/chosen-subject.ts";
import { pageAlone } from "./support/page-here.ts";

const SIDE = 9;

/** Quads of length 1; point v is at (v % 9, ⌊v / 9⌋). */
function grid() {
  const side = Array.from({ length: SIDE }, (_, k) => k);
  const current = Float32Array.from(side.flatMap((y) => side.flatMap((x) => [x, y, 0])));
  const faces = side.slice(1).flatMap((y) =>
    side.slice(1).map((x) => {
      const last = SIDE * y + x;
      return [last - SIDE - 1, last - SIDE, last, last - 1];
    }),
  );
  const vertices = Int32Array.from(faces.flat());
  const offsets = Int32Array.from({ length: faces.length + 1 }, (_, k) => 4 * k);
  const corners = Float32Array.from(
    [...vertices].flatMap((v) => [v % SIDE, Math.floor(v / SIDE), 0]),
  );
  return { current, offsets, corners, topology: buildTopology(offsets, vertices, SIDE * SIDE) };
}

/** Lowest and highest x. */
function widthOf(selection: readonly number[], panel: number | null = null): readonly number[] {
  const page = pageAlone();
  page.selection.value = selection;
  page.selectedPanel.value = panel;
  const xs = [...(chosenOf(page, grid())?.points ?? [])].filter((_, k) => k % 3 === 0);
  return xs.length === 0 ? [] : [Math.min(...xs), Math.max(...xs)];
}

it("is one point with two panels on each side, several with those at them, or one panel", () => {
  expect(widthOf([4 * SIDE + 4])).toEqual([2, 6]);
  expect(widthOf([4 * SIDE + 4, 4 * SIDE + 6])).toEqual([3, 7]);
  expect(widthOf([], 0)).toEqual([0, 1]);
  expect(widthOf([])).toEqual([]);
});
