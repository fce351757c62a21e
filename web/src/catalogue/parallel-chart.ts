// SPDX-License-Identifier: MIT
// The designs as lines over parallel axes (ECharts); an axis is brushed with the pointer.
import { ParallelChart as ParallelSeries } from "echarts/charts";
import { ParallelComponent } from "echarts/components";
import { type EChartsType, init, use } from "echarts/core";
import { CanvasRenderer } from "echarts/renderers";
import type { Filter, Interval } from "./filter.ts";
import { type Axis, inLines, type Table } from "./table.ts";
import type { Theme } from "./theme.ts";

use([ParallelSeries, ParallelComponent, CanvasRenderer]);

const AXIS_MIN_WIDTH_PX = 92;
const HEIGHT_PX = 300;
/** Room for half of the first axis' name. */
const LEFT_PX = 64;

/** What ECharts tells of a brushed axis; its types leave it open. */
interface AxisAreaEvent {
  readonly parallelAxisId?: string;
  readonly intervals?: readonly (readonly [number, number])[];
}

const LINE_PX = 15;

/** Four digits are enough to aim. */
const formatted = (value: number): string => String(Number(value.toPrecision(4)));

function axisOption(axis: Axis, dim: number, theme: Theme): object {
  return {
    id: String(axis.column),
    dim,
    type: "value",
    min: axis.low,
    max: axis.high,
    name: inLines(axis.label),
    nameLocation: "end",
    nameTextStyle: { color: theme.ink, lineHeight: LINE_PX },
    axisLabel: {
      color: theme.ink,
      formatter: formatted,
      hideOverlap: true,
      // Lines run below it.
      textBorderColor: theme.surface,
      textBorderWidth: 3,
    },
    axisLine: { lineStyle: { color: theme.quiet } },
    axisTick: { lineStyle: { color: theme.quiet } },
    splitNumber: 4,
    areaSelectStyle: { color: theme.accent, borderColor: theme.accent, opacity: 0.25, width: 16 },
  };
}

export class ParallelChart {
  readonly #chart: EChartsType;

  /** @param onBrush a column and what was brushed of it */
  constructor(
    element: HTMLElement,
    private readonly table: Table,
    private readonly axes: readonly Axis[],
    onBrush: (column: number, interval: Interval) => void,
  ) {
    element.style.minWidth = `${AXIS_MIN_WIDTH_PX * (axes.length + 1)}px`;
    element.style.height = `${HEIGHT_PX}px`;
    this.#chart = init(element);
    new ResizeObserver(() => this.#chart.resize()).observe(element);
    this.#chart.on("axisareaselected", (event) => {
      const { parallelAxisId, intervals = [] } = event as AxisAreaEvent;
      const [from, to] = intervals[0] ?? [null, null];
      if (parallelAxisId !== undefined) onBrush(Number(parallelAxisId), { from, to });
    });
  }

  draw(theme: Theme): void {
    const rows = this.table.designs.map(({ id, cells }) => ({
      name: id,
      value: this.axes.map(({ column }) => cells[column] ?? "-"),
    }));
    this.#chart.setOption({
      animation: false,
      parallel: {
        left: LEFT_PX,
        right: 64,
        top: 52,
        bottom: 24,
        parallelAxisDefault: { realtime: true },
      },
      parallelAxis: this.axes.map((axis, dim) => axisOption(axis, dim, theme)),
      series: {
        type: "parallel",
        data: rows,
        lineStyle: { color: theme.accent, width: 1, opacity: 0.55 },
        inactiveOpacity: 0.06,
        emphasis: { lineStyle: { color: theme.ink, width: 3, opacity: 1 } },
      },
    });
  }

  /** Shows on the axes what was said elsewhere. */
  show({ intervals }: Filter): void {
    for (const { column, low, high } of this.axes) {
      const said = intervals.get(column);
      const area = said ? [[said.from ?? low, said.to ?? high]] : [];
      // Silent: this is no brushing.
      this.#chart.dispatchAction(
        { type: "axisAreaSelect", parallelAxisId: String(column), intervals: area },
        { silent: true },
      );
    }
  }

  /** Draws one design's line strongly; null: none. */
  point(index: number | null): void {
    this.#chart.dispatchAction({ type: "downplay", seriesIndex: 0 });
    if (index !== null)
      this.#chart.dispatchAction({ type: "highlight", seriesIndex: 0, dataIndex: index });
  }
}
