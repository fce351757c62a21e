// SPDX-License-Identifier: MIT

import { useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import type { HandleRow, Point } from "../design/design.ts";
import { formatLength, niceStep } from "../quantity/units.ts";
import type { Outcome } from "../state/action-queue.ts";
import { FLAT_FIRST } from "../state/dragging.ts";
import {
  addHandle,
  basePoint,
  removeHandle,
  removeHandles,
  setPinned,
  setTarget,
} from "../state/editing.ts";
import type { Page } from "../state/page.ts";
import { selectOnly, toggleSelected } from "../state/selection.ts";
import { type Shortfall, settled, shortfalls, varied } from "../state/shortfall.ts";
import { Icon } from "./icon.tsx";
import { NumberField } from "./number-field.tsx";
import { usePage } from "./page-context.ts";
import { HandleGroups, UnderSelected, UnderTable } from "./places.ts";

const AXES = ["X", "Y", "Z"] as const;

/** Longer tables are cut; the view shows every handle. */
const ROWS = 40;
/** More handles than these, or more pins, are one row each until they are asked for. */
const LISTED = 10;

const stepFor = (meanEdge: number): number => niceStep(meanEdge / 100);

/** How far the point is from its target; kept in place while something moves. */
function Short({ short }: { short: Shortfall }) {
  const page = usePage();
  return (
    <span class={`short${settled(page).value ? "" : " stale"}${short.noticeable ? " far" : ""}`}>
      {formatLength(short.length, page.unit.value)}
      {varied(page).value ? " from the target in this variation" : " short"}
    </span>
  );
}

function Row({ row, step }: { row: HandleRow; step: number }) {
  const page = usePage();
  const shown: Point = row.pinned ? basePoint(page, row.vertex) : row.target;
  const name = `point ${row.vertex}`;
  const short = shortfalls(page).value.find((one) => one.vertex === row.vertex);
  const apply = (axis: number, value: number, burst: string | null): Outcome => {
    const [x, y, z] = row.target.map((old, k) => (k === axis ? value : old));
    return setTarget(page, row.vertex, [x ?? 0, y ?? 0, z ?? 0], burst);
  };
  return (
    <tr
      class={`${page.selection.value.includes(row.vertex) ? "selected" : ""}${short ? " off" : ""}`}
    >
      <th scope="row">
        <button
          type="button"
          class="point-button"
          aria-label={`Select ${name}`}
          onClick={({ ctrlKey, metaKey, shiftKey }) =>
            ctrlKey || metaKey || shiftKey
              ? toggleSelected(page, row.vertex)
              : selectOnly(page, row.vertex)
          }
        >
          {row.vertex}
        </button>
      </th>
      {AXES.map((label, axis) => (
        <td key={label} data-axis={`${label} ${page.unit.value}`}>
          <NumberField
            label={label}
            value={shown[axis] ?? 0}
            unit={page.unit.value}
            step={step}
            disabled={row.pinned}
            context={name}
            place
            onApply={(value, burst) => apply(axis, value, burst)}
          />
          {axis === 0 && short && <Short short={short} />}
        </td>
      ))}
      <td class="narrow">
        <input
          type="checkbox"
          aria-label="Pinned"
          aria-description={name}
          title="Pinned: this point does not move"
          checked={row.pinned}
          onChange={({ currentTarget }) =>
            void setPinned(page, [row.vertex], currentTarget.checked)
          }
        />
      </td>
      <td class="narrow">
        <button
          type="button"
          class="icon-button"
          aria-label="Remove"
          aria-description={name}
          title={`Remove ${name}`}
          onClick={() => void removeHandle(page, row.vertex)}
        >
          <Icon name="close" />
        </button>
      </td>
    </tr>
  );
}

/** Goes on to where the point is typed; not if the focus has left the button by then. */
async function addByKey(
  page: Page,
  button: HTMLButtonElement,
  table: HTMLTableElement | null,
): Promise<void> {
  await addHandle(page);
  if (document.activeElement !== button) return;
  table?.querySelector<HTMLInputElement>(".selected [role=spinbutton]")?.focus();
}

/** Handles or pins: each of a few, of many the one that is selected and how many there are. */
function Rows({ rows, kind, step }: { rows: readonly HandleRow[]; kind: string; step: number }) {
  const page = usePage();
  const listed = useSignal(false);
  const many = rows.length > LISTED;
  const shown =
    many && !listed.value ? rows.filter(({ vertex }) => vertex === page.selected.value) : rows;
  return (
    <>
      {many && <HandleGroups rows={rows} kind={kind} listed={listed} />}
      {shown.slice(0, ROWS).map((row) => (
        <Row key={row.vertex} row={row} step={step} />
      ))}
      {shown.length > ROWS && (
        <tr>
          <td colSpan={6} class="quiet">
            The first {ROWS} of {shown.length}; the view shows all of them.
          </td>
        </tr>
      )}
    </>
  );
}

/** Coordinates from here on, with their decimals, need a line each. */
const LONG = 100;

const LONG_NUMBERS = 10_000;

/** Of the mesh and of where its points are to go, so that the table keeps its form. */
function needsLines(page: Page, rows: readonly HandleRow[]): boolean {
  const report = page.mesh.value?.report;
  if (!report) return false;
  const reach = Math.max(...report.centre.map(Math.abs)) + 5 / report.scale;
  const asked = rows.flatMap(({ target }) => target.map(Math.abs));
  return report.vertices > LONG_NUMBERS || [reach, ...asked].some((size) => size >= LONG);
}

export function HandlesTable() {
  const page = usePage();
  const table = useRef<HTMLTableElement>(null);
  const step = stepFor(page.mesh.value?.report.meanEdge ?? 1);
  const rows = page.handles.value;
  const bent = !page.baseFlat.value;
  const [pins, loose] = [rows.filter((row) => row.pinned), rows.filter((row) => !row.pinned)];
  return (
    <>
      <table
        ref={table}
        class={`handles${rows.length === 0 ? " vacant" : ""}${needsLines(page, rows) ? " lines" : ""}`}
        aria-label="Handles"
      >
        <thead>
          <tr>
            <th scope="col">Point</th>
            {AXES.map((axis) => (
              <th key={axis} scope="col" class="axis">
                {axis} <span class="unit">{page.unit.value}</span>
              </th>
            ))}
            <th scope="col" class="narrow" title="Pinned">
              Pin
            </th>
            <th scope="col" class="narrow">
              <span class="visually-hidden">Remove</span>
            </th>
          </tr>
        </thead>
        <tbody>
          <Rows rows={loose} kind="handles" step={step} />
          <Rows rows={pins} kind="pinned" step={step} />
        </tbody>
      </table>
      <UnderTable />
      {rows.length === 0 && page.baseFlat.value && (
        <p class="quiet empty">Drag a point in the view, or add one and type where it should go.</p>
      )}
      <div class="row">
        <button
          type="button"
          class={`button grow${rows.length === 0 ? " primary" : ""}`}
          disabled={!page.ready.value || !page.baseFlat.value}
          aria-description={bent ? FLAT_FIRST : undefined}
          onClick={({ detail, currentTarget }) =>
            // A key's click counts none.
            void (detail === 0 ? addByKey(page, currentTarget, table.current) : addHandle(page))
          }
        >
          <Icon name="plus" />
          Add handle
        </button>
        {rows.length > 1 && (
          <button
            type="button"
            class="button"
            onClick={() =>
              void removeHandles(
                page,
                rows.map(({ vertex }) => vertex),
              )
            }
          >
            Remove all
          </button>
        )}
      </div>
      {bent && <p class="quiet small">{FLAT_FIRST}</p>}
      {page.selection.value.length > 0 && <UnderSelected />}
    </>
  );
}
