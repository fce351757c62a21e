// SPDX-License-Identifier: MIT

import type { RefObject } from "preact";
import { isKind } from "../design/kept-kind.ts";
import { formatLength } from "../quantity/units.ts";
import { DARK, LIGHT, type Palette } from "../scene/palette.ts";
import { cssGradient } from "../scene/ramp.ts";
import { formatDegrees } from "../state/fold.ts";
import { movesShown } from "../state/moves.ts";
import type { Page } from "../state/page.ts";
import type { ColourBy } from "../state/page-state.ts";
import { defectEnd, foldEnd, largest } from "../state/ramp-ends.ts";
import { Ask } from "./ask.tsx";
import { COLOURS } from "./colours.ts";
import { usePage } from "./page-context.ts";
import type { Place } from "./place.tsx";
import { ENDS, Histograms, LEGENDS } from "./places.ts";

function Bar({ ramp }: { ramp: (palette: Palette) => readonly string[] }) {
  return (
    <>
      <div class="legend-bar light-only" style={{ backgroundImage: cssGradient(ramp(LIGHT)) }} />
      <div class="legend-bar dark-only" style={{ backgroundImage: cssGradient(ramp(DARK)) }} />
    </>
  );
}

function ends(page: Page, kind: ColourBy): readonly [string, string] {
  const { maxDisplacement } = page.figures.value;
  if (kind === "displacement")
    return ["0 mm, untouched", formatLength(maxDisplacement, page.unit.value)];
  if (kind === "shape" || kind === "slide") {
    const end = movesShown(page)?.endOf(kind) ?? 0;
    const length = formatLength(end, page.unit.value);
    return [kind === "shape" && end > 0 ? `−${length}` : "0 mm, untouched", length];
  }
  if (kind === "fold") {
    const end = page.panelFolds.value ? foldEnd(page.panelFolds.value) : 0;
    return ["0°, flat", formatDegrees(end)];
  }
  if (isKind(kind)) {
    const end =
      page.kindDefects.value?.kind === kind ? defectEnd(page.kindDefects.value.values) : 0;
    return ["0°, kept", formatDegrees(end)];
  }
  const sharpest = page.bending.value ? largest(page.bending.value) : 0;
  return ["0 mm, smooth", formatLength(sharpest, page.unit.value)];
}

function Ends({ of }: { of: ColourBy }) {
  const page = usePage();
  const [low, high] = ends(page, of);
  return (
    <div class="legend-ends">
      <span>{low}</span>
      <span>{high}</span>
    </div>
  );
}

/** For kinds whose name does not say all. */
const NOTES: Partial<Record<ColourBy, string>> = {
  shape: "Distance from the old surface",
  slide: "Way along the old surface",
  fairness: "Difference between neighbours' moves",
  fold: "Each panel's sharpest with a neighbour",
  circular: "Opposite angles from 180° together",
  conical: "Opposite angles' sums from each other",
};

function rampOf(kind: ColourBy): (palette: Palette) => readonly string[] {
  if (kind === "shape")
    return ({ lowered, displacement }) => [...lowered.slice(1).reverse(), ...displacement];
  const ofPoints = kind === "slide" || kind === "displacement" || kind === "mobility";
  return (palette) => (ofPoints ? palette.displacement : palette.planarity);
}

const WHOLE: Partial<Record<ColourBy, Place>> = LEGENDS;
const OWN_ENDS: Partial<Record<ColourBy, Place>> = ENDS;

function Scale() {
  const page = usePage();
  const kind = page.colourBy.value;
  if (kind === "none") return null;
  if (kind === "zebra")
    return <p class="legend-note">Mirrored by the smooth surface through the points</p>;
  if (kind === "glass")
    return <p class="legend-note">Each panel mirrors the sky, or lets it through</p>;
  const [Whole, End] = [WHOLE[kind], OWN_ENDS[kind]];
  if (Whole) return <Whole />;
  return (
    <>
      <Histograms />
      <Bar ramp={rampOf(kind)} />
      {End ? <End /> : <Ends of={kind} />}
      {NOTES[kind] && <p class="legend-note">{NOTES[kind]}</p>}
    </>
  );
}

/** Kinds of constraints only where the mesh has panels or nodes that could miss them. */
function choices(page: Page): readonly (readonly [ColourBy, string])[] {
  const kinds = page.mesh.value?.report.kinds;
  return COLOURS.filter(
    ([kind]) => !isKind(kind) || kind === page.colourBy.value || kinds?.[kind]?.worst !== undefined,
  );
}

/** What the colours of the model mean. */
export function Legend({ element }: { element: RefObject<HTMLFieldSetElement | null> }) {
  const page = usePage();
  return (
    <fieldset ref={element} class="legend">
      <legend class="visually-hidden">Legend</legend>
      <label>
        <span class="legend-word">Colour by</span>
        <select
          class="select"
          value={page.colourBy.value}
          onChange={({ currentTarget }) => {
            page.colourBy.value =
              COLOURS.find(([kind]) => kind === currentTarget.value)?.[0] ?? "none";
          }}
        >
          {choices(page).map(([kind, label]) => (
            <option key={kind} value={kind}>
              {label}
            </option>
          ))}
        </select>
      </label>
      <Ask about="colours" />
      <Scale />
    </fieldset>
  );
}
