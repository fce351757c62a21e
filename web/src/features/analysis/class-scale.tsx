// SPDX-License-Identifier: MIT
import { usePage } from "../../ui/page-context.ts";
import "../../ui/legend-scales.css";
import { DARK, LIGHT, type Palette } from "../../scene/palette.ts";
import { showNextPanel } from "../../state/selection.ts";

export interface PanelClass {
  readonly word: string;
  /** Place on the ramp of panels, 0 … 1. */
  readonly place: number;
  /** null until they have been measured. */
  readonly panels: readonly number[] | null;
}

const swatch = ({ planarity }: Palette, place: number): string =>
  planarity[Math.round(place * (planarity.length - 1))] ?? "";

/** Classes of panels with their word and count, never by colour alone; each leads to its panels in turn. */
export function ClassScale({ classes }: { classes: readonly PanelClass[] }) {
  const page = usePage();
  return (
    <ul class="legend-classes">
      {classes.map(({ word, place, panels }) => (
        <li key={word}>
          <button
            type="button"
            disabled={!panels?.length}
            title="Go to the next of these panels"
            onClick={() => panels && showNextPanel(page, panels)}
          >
            <span class="swatch light-only" style={{ background: swatch(LIGHT, place) }} />
            <span class="swatch dark-only" style={{ background: swatch(DARK, place) }} />
            {word} <span class="legend-count">{panels?.length}</span>
          </button>
        </li>
      ))}
    </ul>
  );
}
