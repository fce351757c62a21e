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

/** "options.softness" as "softness"; figures in words. */
export const labelOf = ({ name, kind }: Column): string =>
  kind === "value" ? name.replace(/^options\./, "") : (LABELS[name] ?? name.replaceAll("_", " "));

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
