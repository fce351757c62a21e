// SPDX-License-Identifier: MIT
// The catalogue of a sweep: axes to brush, fields that do the same, and the designs that are left.
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { Cards } from "./cards.tsx";
import { EVERYTHING, type Order, passes, sorted, withInterval } from "./filter.ts";
import { ParallelChart } from "./parallel-chart.ts";
import { Ranges } from "./ranges.tsx";
import { axesOf, choicesOf, type DesignRow, labelOf, shownColumns, type Table } from "./table.ts";
import { currentTheme, onThemeChange } from "./theme.ts";

/** Cards at a time. */
const PAGE_SIZE = 60;

type Setter<T> = (change: (before: T) => T) => void;

/** The chart, drawn once and again where the colours change. */
function useChart(table: Table, setFilter: Setter<typeof EVERYTHING>) {
  const element = useRef<HTMLDivElement>(null);
  const chart = useRef<ParallelChart | null>(null);
  const axes = useMemo(() => axesOf(table), [table]);
  useEffect(() => {
    if (!element.current || axes.length < 2) return;
    const made = new ParallelChart(element.current, table, axes, (column, interval) =>
      setFilter((before) => withInterval(before, column, interval)),
    );
    chart.current = made;
    made.draw(currentTheme());
    onThemeChange(() => made.draw(currentTheme()));
  }, [table, axes, setFilter]);
  return { element, chart, axes };
}

function Sorting({
  table,
  order,
  onOrder,
}: {
  readonly table: Table;
  readonly order: Order | null;
  readonly onOrder: (order: Order | null) => void;
}) {
  return (
    <div class="sorting">
      <label>
        Sort by
        <select
          value={order?.column ?? ""}
          onChange={({ currentTarget: { value } }) =>
            onOrder(value === "" ? null : { column: Number(value), descending: false })
          }
        >
          <option value="">id</option>
          {shownColumns(table).map((k) => {
            const column = table.columns[k];
            return column && <option value={k}>{labelOf(column)}</option>;
          })}
        </select>
      </label>
      {order && (
        <label>
          <input
            type="checkbox"
            checked={order.descending}
            onChange={() => onOrder({ ...order, descending: !order.descending })}
          />
          largest first
        </label>
      )}
    </div>
  );
}

/** What the colours of all pictures mean; scale.svg lies beside the page. */
const MoveScale = ({ largest }: { readonly largest: number }) => (
  <p class="move-scale">
    Panels by how far their farthest corner moves: 0
    <img src="scale.svg" alt="from yellow to violet" />
    {String(Number(largest.toPrecision(4)))}
  </p>
);

export function Catalogue({ table }: { readonly table: Table }) {
  const [filter, setFilter] = useState(EVERYTHING);
  const [order, setOrder] = useState<Order | null>(null);
  const [shown, setShown] = useState(PAGE_SIZE);
  const { element, chart, axes } = useChart(table, setFilter);
  const choices = useMemo(() => choicesOf(table), [table]);
  const left = sorted(
    table.designs.filter((design) => passes(design, filter)),
    order,
  );
  /** Takes what a field says: the axes follow. */
  const say = (said: typeof EVERYTHING): void => {
    setFilter(said);
    chart.current?.show(said);
  };
  const point = (design: DesignRow | null): void =>
    chart.current?.point(design && table.designs.indexOf(design));
  const names = axes.map(({ label }) => label).join(", ");
  return (
    <main>
      <header>
        <h1>{table.title}</h1>
        <p role="status">
          {left.length} of {table.designs.length} designs
        </p>
        <button type="button" onClick={() => say(EVERYTHING)}>
          Show all
        </button>
        <Sorting table={table} order={order} onOrder={setOrder} />
        <a href="results.csv" download>
          Table (CSV)
        </a>
      </header>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls where the axes need more room */}
      <section class="chart" tabIndex={0} aria-label="Chart, a line a design: drag along an axis">
        <div ref={element} role="img" aria-label={`Parallel axes: ${names}`} />
      </section>
      <Ranges axes={axes} choices={choices} filter={filter} onFilter={say} />
      {table.largest > 0 && <MoveScale largest={table.largest} />}
      <Cards table={table} designs={left.slice(0, shown)} onPoint={point} />
      {left.length > shown && (
        <button type="button" class="more" onClick={() => setShown(shown + PAGE_SIZE)}>
          Show {Math.min(PAGE_SIZE, left.length - shown)} more
        </button>
      )}
    </main>
  );
}
