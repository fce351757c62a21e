// SPDX-License-Identifier: MIT

import type { Point } from "../../design/design.ts";
import { counted } from "../../quantity/counted.ts";
import { niceStep } from "../../quantity/units.ts";
import { FLAT_FIRST } from "../../state/dragging.ts";
import { moveInFrame } from "../../state/typed-moves.ts";
import { Ask } from "../../ui/ask.tsx";
import { NumberField } from "../../ui/number-field.tsx";
import { usePage } from "../../ui/page-context.ts";

const DIRECTIONS: readonly (readonly [string, string, Point])[] = [
  ["Along", "along the edge nearest to X, in the surface", [1, 0, 0]],
  ["Across", "at right angles to it, in the surface", [0, 1, 0]],
  ["Out", "along the normal, out of the surface", [0, 0, 1]],
];

/** Typed moves of the selected points in the directions of the surface at each of them. */
export function SurfaceMove() {
  const page = usePage();
  const chosen = page.selection.value;
  const disabled = chosen.length === 0 || !page.ready.value || !page.baseFlat.value;
  return (
    <details class="surface-move">
      <summary>Move along the surface</summary>
      <Ask about="along" />
      <div class="move-fields">
        {DIRECTIONS.map(([label, about, [along, across, out]]) => (
          <div key={label} class="move-field" title={about}>
            <span>
              {label} <span class="unit">{page.unit.value}</span>
            </span>
            <NumberField
              label={label}
              value={0}
              unit={page.unit.value}
              step={niceStep((page.mesh.value?.report.meanEdge ?? 1) / 100)}
              disabled={disabled}
              context={about}
              onApply={(by) => void moveInFrame(page, chosen, [along * by, across * by, out * by])}
            />
          </div>
        ))}
      </div>
      <p class="quiet">
        {!page.baseFlat.value
          ? FLAT_FIRST
          : chosen.length === 0
            ? "Select a point first."
            : `Moves ${counted(chosen.length, "point")} by what you type.`}
      </p>
    </details>
  );
}
