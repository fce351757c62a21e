// SPDX-License-Identifier: MIT
import { DARK, LIGHT } from "../scene/palette.ts";
import { cssGradient } from "../scene/ramp.ts";
import { colourBy, figures, unit } from "../state/store.ts";
import { formatLength } from "../state/units.ts";

/** What the colours of the model mean. */
export function Legend() {
  const { maxDisplacement, movedVertices } = figures.value;
  if (colourBy.value !== "displacement" || movedVertices === 0) return null;
  return (
    <figure class="legend">
      <figcaption>How far points moved</figcaption>
      <div
        class="legend-bar light-only"
        style={{ backgroundImage: cssGradient(LIGHT.displacement) }}
      />
      <div
        class="legend-bar dark-only"
        style={{ backgroundImage: cssGradient(DARK.displacement) }}
      />
      <div class="legend-ends">
        <span>0 mm, untouched</span>
        <span>{formatLength(maxDisplacement, unit.value)}</span>
      </div>
    </figure>
  );
}
