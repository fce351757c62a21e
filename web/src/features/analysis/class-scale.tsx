// SPDX-License-Identifier: MIT
// What panels are coloured by in classes: whether they can be made, and what must be made again.

import { DARK, LIGHT, type Palette } from "../../scene/palette.ts";
import { remakePlace } from "../../scene/ramp.ts";
import { panelsChanged, panelsWith } from "../../state/panel-rows.ts";
import { TROUBLES } from "../../state/panel-trouble.ts";
import { showNextPanel } from "../../state/selection.ts";
import { usePage } from "../../ui/page-context.ts";
import "../../ui/legend-scales.css";

interface PanelClass {
  readonly word: string;
  /** Place on the ramp of panels, 0 … 1. */
  readonly place: number;
  /** null until they have been measured. */
  readonly panels: readonly number[] | null;
}

const swatch = ({ planarity }: Palette, place: number): string =>
  planarity[Math.round(place * (planarity.length - 1))] ?? "";

/** Classes of panels with their word and count, never by colour alone; each leads to its panels in turn. */
function ClassScale({ classes }: { classes: readonly PanelClass[] }) {
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

const WORDS: readonly string[] = TROUBLES.map((word) =>
  word === "crosses itself" ? `${word} (bow-tie)` : word,
);

/** Whether panels can be made. */
export function HealthScale() {
  const page = usePage();
  const troubles = page.panelTroubles.value;
  const classes = WORDS.map((word, trouble) => ({
    word,
    place: trouble / (WORDS.length - 1),
    panels: troubles && panelsWith(trouble, troubles),
  }));
  return <ClassScale classes={classes} />;
}

/** By the core's PanelChange, in the order of the ramp. */
const CLASSES = [
  ["unchanged", 0],
  ["new bevel only", 2],
  ["cut again", 1],
] as const;

/** What the shop makes again after the edit. */
export function RemakeScale() {
  const page = usePage();
  const health = page.panelHealth.value;
  const classes = CLASSES.map(([word, change]) => ({
    word,
    place: remakePlace(change),
    panels: health && panelsChanged(health, change),
  }));
  return <ClassScale classes={classes} />;
}
