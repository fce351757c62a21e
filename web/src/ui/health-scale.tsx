// SPDX-License-Identifier: MIT
import "./legend-scales.css";
import { DARK, LIGHT, type Palette } from "../scene/palette.ts";
import { countHealth, panelsOfOutline } from "../state/panel-rows.ts";
import { showNextPanel } from "../state/selection.ts";
import { panelHealth } from "../state/store.ts";

const swatch = (palette: Palette, k: number): string => palette.planarity[2 * k] ?? palette.panel;

/** Classes with their word and count, never by colour alone; each leads to its panels in turn. */
export function HealthScale() {
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
          <button
            type="button"
            disabled={!count}
            title="Go to the next of these panels"
            onClick={() => health && showNextPanel(panelsOfOutline(health, k))}
          >
            <span class="swatch light-only" style={{ background: swatch(LIGHT, k) }} />
            <span class="swatch dark-only" style={{ background: swatch(DARK, k) }} />
            {word} <span class="legend-count">{count}</span>
          </button>
        </li>
      ))}
    </ul>
  );
}
