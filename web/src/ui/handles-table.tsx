// SPDX-License-Identifier: MIT
import type { HandleRow, Point } from "../state/design.ts";
import { addHandle, basePoint, removeHandle, setPinned, setTarget } from "../state/editing.ts";
import { handles, mesh, ready, selected, unit } from "../state/store.ts";
import { Icon } from "./icon.tsx";
import { NumberField } from "./number-field.tsx";

const AXES = ["X", "Y", "Z"] as const;

/** A step that suits the mesh: 1, 2 or 5 times a power of ten, about a hundredth of an edge. */
function niceStep(meanEdge: number): number {
  const rough = meanEdge / 100 || 0.01;
  const power = 10 ** Math.floor(Math.log10(rough));
  const lead = rough / power;
  return (lead < 2 ? 1 : lead < 5 ? 2 : 5) * power;
}

function Row({ row, step }: { row: HandleRow; step: number }) {
  const shown: Point = row.pinned ? basePoint(row.vertex) : row.target;
  const name = `point ${row.vertex}`;
  const apply = (axis: number, value: number): void => {
    const [x, y, z] = row.target.map((old, k) => (k === axis ? value : old));
    void setTarget(row.vertex, [x ?? 0, y ?? 0, z ?? 0]);
  };
  return (
    <tr class={row.vertex === selected.value ? "selected" : ""}>
      <th scope="row">
        <button
          type="button"
          class="point-button"
          aria-label={`Select ${name}`}
          onClick={() => {
            selected.value = row.vertex;
          }}
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
            onApply={(value) => apply(axis, value)}
          />
        </td>
      ))}
      <td class="narrow">
        <input
          type="checkbox"
          aria-label="Pinned"
          aria-description={name}
          title="Pinned: this point does not move"
          checked={row.pinned}
          onChange={({ currentTarget }) => void setPinned(row.vertex, currentTarget.checked)}
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

export function HandlesTable() {
  const step = niceStep(mesh.value?.report.meanEdge ?? 1);
  return (
    <>
      <table class="handles" aria-label="Handles">
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
          {handles.value.map((row) => (
            <Row key={row.vertex} row={row} step={step} />
          ))}
        </tbody>
      </table>
      {handles.value.length === 0 && (
        <p class="quiet empty">Drag a point in the view, or add one and type where it should go.</p>
      )}
      <button
        type="button"
        class={`button wide${handles.value.length === 0 ? " primary" : ""}`}
        disabled={!ready.value || !mesh.value?.report.flat}
        onClick={() => void addHandle()}
      >
        <Icon name="plus" />
        Add handle
      </button>
    </>
  );
}
