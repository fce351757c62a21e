// SPDX-License-Identifier: MIT
import { useRef } from "preact/hooks";
import type { HandleRow, Point } from "../state/design.ts";
import { FLAT_FIRST } from "../state/dragging.ts";
import { addHandle, basePoint, removeHandle, setPinned, setTarget } from "../state/editing.ts";
import { selectOnly, toggleSelected } from "../state/selection.ts";
import { type Shortfall, settled, shortfalls, varied } from "../state/shortfall.ts";
import { baseFlat, handles, mesh, ready, selection, unit } from "../state/store.ts";
import { formatLength, niceStep } from "../state/units.ts";
import { Icon } from "./icon.tsx";
import { later } from "./later.tsx";
import { NumberField } from "./number-field.tsx";

const SurfaceMove = later(() => import("./surface-move.tsx").then((part) => part.SurfaceMove));

const AXES = ["X", "Y", "Z"] as const;

/** Longer tables are cut; the view shows every handle. */
const ROWS = 40;

const stepFor = (meanEdge: number): number => niceStep(meanEdge / 100);

const MeetTargets = later(() => import("./meet-targets.tsx").then((part) => part.MeetTargets));

/** How far the point is from its target; kept in place while something moves. */
function Short({ short }: { short: Shortfall }) {
  return (
    <span class={settled.value ? "short" : "short stale"}>
      {formatLength(short.length, unit.value)}
      {varied.value ? " from the target, by the variation" : " short"}
    </span>
  );
}

function Row({ row, step }: { row: HandleRow; step: number }) {
  const shown: Point = row.pinned ? basePoint(row.vertex) : row.target;
  const name = `point ${row.vertex}`;
  const short = shortfalls.value.find((one) => one.vertex === row.vertex);
  const apply = (axis: number, value: number, burst: string | null): Promise<void> => {
    const [x, y, z] = row.target.map((old, k) => (k === axis ? value : old));
    return setTarget(row.vertex, [x ?? 0, y ?? 0, z ?? 0], burst);
  };
  return (
    <tr class={`${selection.value.includes(row.vertex) ? "selected" : ""}${short ? " off" : ""}`}>
      <th scope="row">
        <button
          type="button"
          class="point-button"
          aria-label={`Select ${name}`}
          onClick={({ ctrlKey, metaKey, shiftKey }) =>
            ctrlKey || metaKey || shiftKey ? toggleSelected(row.vertex) : selectOnly(row.vertex)
          }
        >
          {row.vertex}
        </button>
      </th>
      {AXES.map((label, axis) => (
        <td key={label}>
          <NumberField
            label={label}
            value={shown[axis] ?? 0}
            unit={unit.value}
            step={step}
            disabled={row.pinned}
            context={name}
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
          onChange={({ currentTarget }) => void setPinned([row.vertex], currentTarget.checked)}
        />
      </td>
      <td class="narrow">
        <button
          type="button"
          class="icon-button"
          aria-label="Remove"
          aria-description={name}
          title={`Remove ${name}`}
          onClick={() => void removeHandle(row.vertex)}
        >
          <Icon name="close" />
        </button>
      </td>
    </tr>
  );
}

/** Goes on to where the point is typed; not if the focus has left the button by then. */
async function addByKey(button: HTMLButtonElement, table: HTMLTableElement | null): Promise<void> {
  await addHandle();
  if (document.activeElement !== button) return;
  table?.querySelector<HTMLInputElement>(".selected [role=spinbutton]")?.focus();
}

export function HandlesTable() {
  const table = useRef<HTMLTableElement>(null);
  const step = stepFor(mesh.value?.report.meanEdge ?? 1);
  const rows = handles.value;
  const bent = !baseFlat.value;
  return (
    <>
      <table
        ref={table}
        class={rows.length === 0 ? "handles vacant" : "handles"}
        aria-label="Handles"
      >
        <thead>
          <tr>
            <th scope="col">Point</th>
            {AXES.map((axis) => (
              <th key={axis} scope="col">
                {axis} <span class="unit">{unit.value}</span>
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
          {rows.slice(0, ROWS).map((row) => (
            <Row key={row.vertex} row={row} step={step} />
          ))}
        </tbody>
      </table>
      <MeetTargets />
      {rows.length > ROWS && (
        <p class="quiet">
          The first {ROWS} of {rows.length}; the view shows all of them.
        </p>
      )}
      {rows.length === 0 && baseFlat.value && (
        <p class="quiet empty">Drag a point in the view, or add one and type where it should go.</p>
      )}
      <button
        type="button"
        class={`button wide${rows.length === 0 ? " primary" : ""}`}
        disabled={!ready.value || !baseFlat.value}
        aria-description={bent ? FLAT_FIRST : undefined}
        onClick={({ detail, currentTarget }) =>
          // A key's click counts none.
          void (detail === 0 ? addByKey(currentTarget, table.current) : addHandle())
        }
      >
        <Icon name="plus" />
        Add handle
      </button>
      {bent && <p class="quiet small">{FLAT_FIRST}</p>}
      <SurfaceMove />
    </>
  );
}
