// SPDX-License-Identifier: MIT
// Which designs are looked at, and in what order.
import type { Cell, DesignRow } from "./table.ts";

/** From one value to another, both included; null: open. */
export interface Interval {
  readonly from: number | null;
  readonly to: number | null;
}

export interface Filter {
  /** By column. */
  readonly intervals: ReadonlyMap<number, Interval>;
  readonly words: ReadonlyMap<number, string>;
}

export const EVERYTHING: Filter = { intervals: new Map(), words: new Map() };

export interface Order {
  readonly column: number;
  readonly descending: boolean;
}

const inside = (cell: Cell, { from, to }: Interval): boolean =>
  typeof cell === "number" && (from === null || cell >= from) && (to === null || cell <= to);

export const passes = ({ cells }: DesignRow, { intervals, words }: Filter): boolean =>
  [...intervals].every(([column, interval]) => inside(cells[column] ?? null, interval)) &&
  [...words].every(([column, word]) => cells[column] === word);

/** `filter` with `interval` in place of what it said of `column`; an open one says nothing. */
export function withInterval(filter: Filter, column: number, interval: Interval): Filter {
  const intervals = new Map(filter.intervals);
  intervals.delete(column);
  if (interval.from !== null || interval.to !== null) intervals.set(column, interval);
  return { ...filter, intervals };
}

/** "" for all words. */
export function withWord(filter: Filter, column: number, word: string): Filter {
  const words = new Map(filter.words);
  words.delete(column);
  if (word) words.set(column, word);
  return { ...filter, words };
}

/** Numbers before words, nothing last. */
function compare(a: Cell, b: Cell): number {
  if (typeof a === "number" && typeof b === "number") return a - b;
  const rank = (cell: Cell): number => (cell === null ? 2 : Number(typeof cell === "string"));
  return rank(a) - rank(b) || String(a).localeCompare(String(b), "en");
}

export function sorted(designs: readonly DesignRow[], order: Order | null): DesignRow[] {
  if (!order) return [...designs];
  const { column, descending } = order;
  return [...designs].sort((a, b) => {
    const [left, right] = [a.cells[column] ?? null, b.cells[column] ?? null];
    // What has no figure comes last either way.
    if (left === null || right === null) return compare(left, right);
    return descending ? compare(right, left) : compare(left, right);
  });
}
