// SPDX-License-Identifier: MIT
// What planish.catalogue() writes into designs.js: results.csv with pictures and links.

export type Cell = number | string | null;

export interface Column {
  readonly name: string;
  /** What the sweep varied, or what came out. */
  readonly kind: "value" | "figure";
}

export interface DesignRow {
  readonly id: string;
  /** One for each column. */
  readonly cells: readonly Cell[];
  /** Paths below the catalogue's folder; null where there is none. */
  readonly picture: string | null;
  readonly file: string | null;
  /** Address that opens the design in the editor and verifies it. */
  readonly link: string | null;
}

export interface Table {
  readonly title: string;
  /** The move, in the designs' unit, that has the last colour of the pictures' scale; 0: nothing moves. */
  readonly largest: number;
  readonly columns: readonly Column[];
  readonly designs: readonly DesignRow[];
}

/** A column of numbers that differ: an axis of the chart. */
export interface Axis {
  readonly column: number;
  readonly label: string;
  readonly low: number;
  readonly high: number;
}

/** A column of words that differ: a choice. */
export interface Choice {
  readonly column: number;
  readonly label: string;
  readonly words: readonly string[];
}

const LABELS: Readonly<Record<string, string>> = {
  design: "file",
  handle_error: "handle error",
  max_displacement: "largest move",
  moved_vertices: "points moved",
  remake_bevel: "panels with a new bevel",
  remake_nodes_arms: "nodes with new arms",
  remake_nodes_moved: "nodes moved",
  remake_outline: "panels made again",
  shape_max: "farthest from the old surface",
  sharpest_fold_after: "sharpest fold, °",
  slide_max: "longest slide along it",
};

/** Always nearly 0, the same for all designs, or of no use to whoever chooses one. */
const NOT_SHOWN = new Set(["design", "message", "planarity_mm_per_m", "iterations"]);

/** A field of a handle: `handles[0].by[2]`, or `handles[0][3]` of the list vertex, x, y, z. */
const HANDLE_FIELD = /^handles\[(\d+)\](?:\.(by)\[([0-2])\]|\[([0-3])\])$/;
const AXIS_NAMES = ["x", "y", "z"];

/** "lift of handle 1, z"; null: no field of a handle. Handles count from 1, as people count. */
function handleLabel(name: string): string | null {
  const [, index, by, along, place] = HANDLE_FIELD.exec(name) ?? [];
  if (index === undefined) return null;
  const handle = `handle ${Number(index) + 1}`;
  if (by) return `${along === "2" ? "lift" : "move"} of ${handle}, ${AXIS_NAMES[Number(along)]}`;
  return place === "0"
    ? `point of ${handle}`
    : `place of ${handle}, ${AXIS_NAMES[Number(place) - 1]}`;
}

/** "options.keep_boundary" as "keep boundary"; figures in words. */
export const labelOf = ({ name, kind }: Column): string => {
  const words = (): string => name.replace(/^options\./, "").replaceAll("_", " ");
  return kind === "value" ? (handleLabel(name) ?? words()) : (LABELS[name] ?? words());
};

/** What an axis of the chart has room for; ECharts cuts off the rest of a line. */
const MOST_LETTERS = 16;

/** The name of an axis, in lines. */
export const inLines = (label: string): string =>
  label.split(" ").reduce((lines, word) => {
    const last = lines.length - lines.lastIndexOf("\n") - 1;
    return `${lines}${last + 1 + word.length <= MOST_LETTERS ? " " : "\n"}${word}`;
  });

export const shownColumns = ({ columns }: Table): number[] =>
  columns.flatMap(({ name, kind }, k) => (kind === "value" || !NOT_SHOWN.has(name) ? [k] : []));

const cellsOf = ({ designs }: Table, column: number): Cell[] =>
  designs.map(({ cells }) => cells[column] ?? null);

export function axesOf(table: Table): Axis[] {
  return shownColumns(table).flatMap((column) => {
    const numbers = cellsOf(table, column).filter((cell) => typeof cell === "number");
    const [low, high] = [Math.min(...numbers), Math.max(...numbers)];
    const label = labelOf(table.columns[column] as Column);
    return numbers.length > 0 && low < high ? [{ column, label, low, high }] : [];
  });
}

export function choicesOf(table: Table): Choice[] {
  return shownColumns(table).flatMap((column) => {
    const cells = cellsOf(table, column).filter((cell) => typeof cell === "string");
    const words = [...new Set(cells)].sort();
    const label = labelOf(table.columns[column] as Column);
    return words.length > 1 ? [{ column, label, words }] : [];
  });
}
