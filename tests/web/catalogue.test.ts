// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import {
  EVERYTHING,
  passes,
  sorted,
  withInterval,
  withWord,
} from "../../web/src/catalogue/filter.ts";
import {
  axesOf,
  type Cell,
  choicesOf,
  inLines,
  labelOf,
  type Table,
} from "../../web/src/catalogue/table.ts";

const NO_DOORS = { picture: null, file: null, link: null };
const row = (id: string, ...cells: Cell[]) => ({ id, cells, ...NO_DOORS });
const TABLE: Table = {
  title: "",
  largest: 0,
  columns: [
    { name: "options.softness", kind: "value" },
    { name: "status", kind: "figure" },
    { name: "moved_vertices", kind: "figure" },
    { name: "iterations", kind: "figure" },
    { name: "objective", kind: "figure" },
  ],
  designs: [
    row("a", 2, "converged", 30, 8, 1),
    row("b", 5, "converged", 60, 9, 1),
    row("c", 8, "refused", null, null, null),
  ],
};
const ids = (filter: typeof EVERYTHING): string[] =>
  TABLE.designs.filter((design) => passes(design, filter)).map(({ id }) => id);

it("axes are numbers that differ, choices are words that differ", () => {
  expect(axesOf(TABLE)).toEqual([
    { column: 0, label: "softness", low: 2, high: 8 },
    { column: 2, label: "points moved", low: 30, high: 60 },
  ]);
  expect(choicesOf(TABLE)).toEqual([
    { column: 1, label: "status", words: ["converged", "refused"] },
  ]);
});

it("a design is left if it is inside of every interval and has every word", () => {
  const soft = withInterval(EVERYTHING, 0, { from: 5, to: null });
  expect(ids(EVERYTHING)).toEqual(["a", "b", "c"]);
  expect(ids(soft)).toEqual(["b", "c"]);
  expect(ids(withWord(soft, 1, "converged"))).toEqual(["b"]);
  expect(ids(withInterval(soft, 2, { from: null, to: 100 }))).toEqual(["b"]); // no figure, not inside
  expect(withInterval(soft, 0, { from: null, to: null })).toEqual(EVERYTHING);
  expect(withWord(withWord(EVERYTHING, 1, "refused"), 1, "")).toEqual(EVERYTHING);
});

it("designs without a figure come last, whichever way the others are sorted", () => {
  const order = (descending: boolean): string[] =>
    sorted(TABLE.designs, { column: 2, descending }).map(({ id }) => id);
  expect(order(false)).toEqual(["a", "b", "c"]);
  expect(order(true)).toEqual(["b", "a", "c"]);
});

it("what a sweep varied is named in plain words, handles counted from 1", () => {
  const label = (name: string): string => labelOf({ name, kind: "value" });
  expect(label("handles[0].by[2]")).toBe("lift of handle 1, z");
  expect(label("handles[11].by[0]")).toBe("move of handle 12, x");
  expect(label("handles[0][0]")).toBe("point of handle 1");
  expect(label("handles[1][3]")).toBe("place of handle 2, z");
  expect(label("options.keep_boundary")).toBe("keep boundary");
  expect(label("variations[0].coefficients[1]")).toBe("variations[0].coefficients[1]");
});

it("a name that is wider than its axis has lines, broken between words", () => {
  expect(inLines("lift of handle 12, z")).toBe("lift of handle\n12, z");
  expect(inLines("farthest from the old surface")).toBe("farthest from\nthe old surface");
  expect(inLines("softness")).toBe("softness");
});
