// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import {
  EVERYTHING,
  passes,
  sorted,
  withInterval,
  withWord,
} from "../../web/src/catalogue/filter.ts";
import { axesOf, type Cell, choicesOf, type Table } from "../../web/src/catalogue/table.ts";

const NO_DOORS = { picture: null, file: null, link: null };
const row = (id: string, ...cells: Cell[]) => ({ id, cells, ...NO_DOORS });
const TABLE: Table = {
  title: "",
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
