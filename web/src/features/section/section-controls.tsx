// SPDX-License-Identifier: MIT
// Cuts the view open along a plane, and says what it cuts.

import { useEffect } from "preact/hooks";
import { sectionLength } from "../../mesh/plane-section.ts";
import { counted } from "../../quantity/counted.ts";
import { formatLength } from "../../quantity/units.ts";
import { sectionPlane } from "../../state/shown-section.ts";
import { Ask } from "../../ui/ask.tsx";
import { Check } from "../../ui/check.tsx";
import { Choice } from "../../ui/choice.tsx";
import { LimitField } from "../../ui/limit-field.tsx";
import { usePage } from "../../ui/page-context.ts";
import { viewOf } from "../../ui/view-slot.ts";
import { followSection } from "./section-follower.ts";
import { cutAcross, rangeAlong, section } from "./section-plane.ts";

const ACROSS: readonly (readonly [string, string])[] = [
  ["", "nothing"],
  ["0", "across X"],
  ["1", "across Y"],
  ["2", "level"],
];

const AXES = { "": null, "0": 0, "1": 1, "2": 2 } as const;

function Place() {
  const page = usePage();
  const shown = sectionPlane(page);
  const plane = shown.value;
  const cut = section(page).value;
  if (!plane || !cut) return null;
  const [low, high] = rangeAlong(page, plane.axis);
  const move = (at: number): void => {
    shown.value = { ...plane, at };
  };
  return (
    <>
      <div class="field">
        <span>{`At ${"XYZ"[plane.axis]}, ${page.unit.value}`}</span>
        <LimitField
          label="Section at"
          about={`${page.unit.value}, of the model`}
          value={plane.at}
          unit={page.unit.value}
          invalid={false}
          onApply={move}
        />
      </div>
      <input
        type="range"
        class="section-slider"
        aria-label="Move the section"
        min={low}
        max={high}
        step={(high - low) / 200 || 1}
        value={plane.at}
        onInput={({ currentTarget }) => move(Number(currentTarget.value))}
      />
      <Check
        label="Show the other side"
        checked={plane.flipped}
        onChange={(on) => {
          shown.value = { ...plane, flipped: on };
        }}
      />
      <p class="quiet small">
        {cut.panels === 0
          ? "It cuts nothing there."
          : `Cuts ${counted(cut.panels, "panel")}, ${formatLength(sectionLength(cut), page.unit.value)} in all. To scale: Export, Drawings…`}
      </p>
    </>
  );
}

export function SectionControls() {
  const page = usePage();
  useEffect(() => {
    const view = viewOf(page);
    return view ? followSection(page, view) : undefined;
  }, []);
  const axis = sectionPlane(page).value?.axis;
  return (
    <section class="step" aria-labelledby="section-plane">
      <h2 id="section-plane">Section</h2>
      <Ask about="section" />
      <Choice
        label="Cut the view"
        value={axis === undefined ? "" : String(axis)}
        words={ACROSS}
        onChoose={(chosen) => cutAcross(page, AXES[chosen as keyof typeof AXES])}
      />
      <Place />
    </section>
  );
}
