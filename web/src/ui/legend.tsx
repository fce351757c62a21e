// SPDX-License-Identifier: MIT
import { DARK, LIGHT, type Palette } from "../scene/palette.ts";
import { cssGradient, FABRICATION_LIMIT } from "../scene/ramp.ts";
import { type ColourBy, colourBy, figures, unit } from "../state/store.ts";
import { formatLength } from "../state/units.ts";

const CHOICES: readonly (readonly [ColourBy, string])[] = [
  ["displacement", "Displacement"],
  ["planarity", "Planarity"],
  ["health", "Panel health"],
  ["none", "Nothing"],
];

function Bar({ ramp }: { ramp: (palette: Palette) => readonly string[] }) {
  return (
    <>
      <div class="legend-bar light-only" style={{ backgroundImage: cssGradient(ramp(LIGHT)) }} />
      <div class="legend-bar dark-only" style={{ backgroundImage: cssGradient(ramp(DARK)) }} />
    </>
  );
}

/** Three classes, each with its word: never by colour alone. */
function HealthScale() {
  const swatch = (palette: Palette, k: number): string => palette.planarity[2 * k] ?? palette.panel;
  return (
    <ul class="legend-classes">
      {["convex", "concave", "crosses itself (bow-tie)"].map((word, k) => (
        <li key={word}>
          <span class="swatch light-only" style={{ background: swatch(LIGHT, k) }} />
          <span class="swatch dark-only" style={{ background: swatch(DARK, k) }} />
          {word}
        </li>
      ))}
    </ul>
  );
}

function Scale() {
  if (colourBy.value === "none") return null;
  if (colourBy.value === "health") return <HealthScale />;
  const moved = colourBy.value === "displacement";
  const ends = moved
    ? ["0 mm, untouched", formatLength(figures.value.maxDisplacement, unit.value)]
    : ["flat", `${FABRICATION_LIMIT} mm/m or more`];
  return (
    <>
      <Bar ramp={(palette) => (moved ? palette.displacement : palette.planarity)} />
      <div class="legend-ends">
        <span>{ends[0]}</span>
        <span>{ends[1]}</span>
      </div>
    </>
  );
}

/** What the colours of the model mean. */
export function Legend() {
  return (
    <div class="legend">
      <label>
        <span class="legend-word">Colour by</span>
        <select
          class="select"
          value={colourBy.value}
          onChange={({ currentTarget }) => {
            colourBy.value = CHOICES.find(([kind]) => kind === currentTarget.value)?.[0] ?? "none";
          }}
        >
          {CHOICES.map(([kind, label]) => (
            <option key={kind} value={kind}>
              {label}
            </option>
          ))}
        </select>
      </label>
      <Scale />
    </div>
  );
}
