// SPDX-License-Identifier: MIT
import type { Point } from "../state/design.ts";
import { FLAT_FIRST, moveInFrame } from "../state/dragging.ts";
import { baseFlat, mesh, ready, selection, unit } from "../state/store.ts";
import { niceStep } from "../state/units.ts";
import { NumberField } from "./number-field.tsx";

const DIRECTIONS: readonly (readonly [string, string, Point])[] = [
  ["Along", "along the edge nearest to X, in the surface", [1, 0, 0]],
  ["Across", "at right angles to it, in the surface", [0, 1, 0]],
  ["Out", "along the normal, out of the surface", [0, 0, 1]],
];

const count = (points: number): string => (points === 1 ? "1 point" : `${points} points`);

/** Typed moves of the selected points in the directions of the surface at each of them. */
export function SurfaceMove() {
  const chosen = selection.value;
  const disabled = chosen.length === 0 || !ready.value || !baseFlat.value;
  return (
    <details class="surface-move">
      <summary>Move along the surface</summary>
      <div class="move-fields">
        {DIRECTIONS.map(([label, about, [along, across, out]]) => (
          <div key={label} class="move-field" title={about}>
            <span>
              {label} <span class="unit">{unit.value}</span>
            </span>
            <NumberField
              label={label}
              value={0}
              unit={unit.value}
              step={niceStep((mesh.value?.report.meanEdge ?? 1) / 100)}
              disabled={disabled}
              context={about}
              onApply={(by) => void moveInFrame(chosen, [along * by, across * by, out * by])}
            />
          </div>
        ))}
      </div>
      <p class="quiet">
        {!baseFlat.value
          ? FLAT_FIRST
          : chosen.length === 0
            ? "Select a point first."
            : `Moves ${count(chosen.length)} by what you type.`}
      </p>
    </details>
  );
}
