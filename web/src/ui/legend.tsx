// SPDX-License-Identifier: MIT
import { DARK, LIGHT, type Palette } from "../scene/palette.ts";
import { cssGradient, FABRICATION_LIMIT } from "../scene/ramp.ts";
import { countHealth } from "../state/analysis.ts";
import { flatnessWords } from "../state/flatness.ts";
import { bending, type ColourBy, colourBy, figures, panelHealth, unit } from "../state/store.ts";
import { formatLength } from "../state/units.ts";
import { later } from "./later.tsx";

const Histogram = later(() => import("./histogram.tsx").then((part) => part.Histogram));

const CHOICES: readonly (readonly [ColourBy, string])[] = [
  ["displacement", "Displacement"],
  ["planarity", "Planarity"],
  ["fairness", "Fairness"],
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

/** Three classes, each with its word and count: never by colour alone. */
function HealthScale() {
  const swatch = (palette: Palette, k: number): string => palette.planarity[2 * k] ?? palette.panel;
  const health = panelHealth.value;
  const counts = health && countHealth(health);
  const classes = [
    ["convex", counts?.convex],
    ["concave", counts?.concave],
    ["crosses itself (bow-tie)", counts?.crossing],
  ] as const;
  return (
    <ul class="legend-classes">
      {classes.map(([word, count], k) => (
        <li key={word}>
          <span class="swatch light-only" style={{ background: swatch(LIGHT, k) }} />
          <span class="swatch dark-only" style={{ background: swatch(DARK, k) }} />
          {word}
          <span class="legend-count">{count}</span>
        </li>
      ))}
    </ul>
  );
}

function ends(kind: "displacement" | "planarity" | "fairness"): readonly [string, string] {
  const { maxDisplacement } = figures.value;
  if (kind === "displacement")
    return ["0 mm, untouched", formatLength(maxDisplacement, unit.value)];
  if (kind === "planarity") return ["flat", `${FABRICATION_LIMIT} mm/m or more`];
  const sharpest = bending.value?.reduce((most, bend) => Math.max(most, bend), 0) ?? 0;
  return ["0 mm, smooth", formatLength(sharpest, unit.value)];
}

/** The figure itself where the ramp says mm/m, and what is measured where it is not plain. */
function Note() {
  const { worstGap, worstMmPerM } = figures.value;
  if (colourBy.value === "fairness")
    return <p class="legend-note">Difference between neighbours' moves</p>;
  if (colourBy.value !== "planarity") return null;
  return (
    <p class="legend-note">{`Worst panel ${flatnessWords(worstGap, worstMmPerM, unit.value).sentence}`}</p>
  );
}

function Scale() {
  const kind = colourBy.value;
  if (kind === "none") return null;
  if (kind === "health") return <HealthScale />;
  const [low, high] = ends(kind);
  return (
    <>
      <Histogram />
      <Bar
        ramp={(palette) => (kind === "displacement" ? palette.displacement : palette.planarity)}
      />
      <div class="legend-ends">
        <span>{low}</span>
        <span>{high}</span>
      </div>
      <Note />
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
