// SPDX-License-Identifier: MIT
// How far an edit may reach and how softly it bends, with what each of them does at once.

import { FIRST_SETTINGS } from "../design/design.ts";
import { boundaryForm, withBoundary } from "../design/supports.ts";
import { counted } from "../quantity/counted.ts";
import { formatLength } from "../quantity/units.ts";
import { commitSettings, letReachGrow, previewSettings } from "../state/editing.ts";
import { foldWords } from "../state/fold.ts";
import type { Page } from "../state/page.ts";
import { growsReach } from "../state/reach-choice.ts";
import { panelsToRemake } from "../state/remaking.ts";
import { Choice } from "./choice.tsx";
import { usePage } from "./page-context.ts";
import { UnderSoftness } from "./places.ts";
import { Slider } from "./slider.tsx";

const MOST_RINGS = 12;
/** One step beyond the most rings. */
const NO_LIMIT = MOST_RINGS + 1;
/** The core's kHardest and kSoftest; at 0 the raw weights hold. */
const [HARDEST, SOFTEST] = [1, 10];

const movedWords = (moved: number): string => {
  if (moved === 0) return "";
  return moved === 1 ? "1 point moves" : `${moved} points move`;
};

/** "81 points, 100 panels again": short, so that it stays one line. */
function effectWords(page: Page): string {
  const moved = page.figures.value.movedVertices;
  const panels = panelsToRemake(page);
  if (panels === 0) return movedWords(moved);
  return `${counted(moved, "point")}, ${counted(panels, "panel")} again`;
}

function Reach() {
  const page = usePage();
  const settings = page.settings.value ?? FIRST_SETTINGS;
  const { reach, reachLength } = settings;
  const grows = growsReach(page, settings);
  const limits = [
    ...(reach > 0 ? [counted(reach, "panel")] : []),
    ...(reachLength > 0 ? [formatLength(reachLength, page.unit.value)] : []),
  ];
  const moved = movedWords(page.figures.value.movedVertices);
  const stated = limits.join(", ") || "no limit";
  const shown = !grows ? stated : moved ? `${stated}, as needed` : "as needed";
  const usable = page.ready.value && settings.softness > 0 && !settings.hardHandles;
  const change = (value: number) => ({
    reach: value === NO_LIMIT ? 0 : value,
    reachLength: 0,
  });
  const slider = (
    <Slider
      label="Reach"
      value={reach === 0 ? NO_LIMIT : Math.min(reach, MOST_RINGS)}
      min={1}
      max={NO_LIMIT}
      step={1}
      shown={shown}
      disabled={!page.ready.value}
      ends={["next panels only", "no limit"]}
      effect={effectWords(page)}
      onInput={(value) => previewSettings(page, change(value))}
      onCommit={(value, burst) => commitSettings(page, change(value), burst)}
    />
  );
  if (grows || !usable) return slider;
  return (
    <>
      {slider}
      <button type="button" class="text-button" onClick={() => void letReachGrow(page)}>
        As far as needed
      </button>
    </>
  );
}

function Softness() {
  const page = usePage();
  const { softness } = page.settings.value ?? FIRST_SETTINGS;
  const shown = softness > 0 ? softness.toFixed(0) : "by the raw weights";
  const { attraction } = FIRST_SETTINGS;
  const change = (value: number) =>
    softness > 0 ? { softness: value } : { softness: value, attraction };
  return (
    <Slider
      label="Softness"
      value={Math.max(softness, HARDEST)}
      min={HARDEST}
      max={SOFTEST}
      step={1}
      shown={shown}
      spoken={softness > 0 ? `${shown} of ${SOFTEST}` : shown}
      disabled={!page.ready.value}
      ends={["close and firm", "wide and gentle"]}
      effect={foldWords(page.figures.value)}
      onInput={(value) => previewSettings(page, change(value))}
      onCommit={(value, burst) => commitSettings(page, change(value), burst)}
    />
  );
}

const FIXED = "fixed";

const BOUNDARIES: readonly (readonly [string, string])[] = [
  [FIXED, "fixed"],
  ["", "free"],
  ["level=z", "keeps its level"],
  ["outline", "on its outline"],
  ["surface", "on the surface"],
];

/** A link or a file may have it kept where it is and say what those of its points that are dragged do. */
function alsoGiven(keepBoundary: boolean, form: string): readonly (readonly [string, string])[] {
  if (form === "") return [];
  const words = BOUNDARIES.find(([known]) => known === form)?.[1] ?? form;
  if (keepBoundary) return [[`${FIXED} ${form}`, `fixed, but where dragged: ${words}`]];
  return words === form ? [[form, form]] : [];
}

/** What the points of the boundary may do; those that are dragged move all the same. */
function Boundary() {
  const page = usePage();
  const { keepBoundary, supports } = page.settings.value ?? FIRST_SETTINGS;
  const form = boundaryForm(supports);
  const words = [...BOUNDARIES, ...alsoGiven(keepBoundary, form)];
  return (
    <Choice
      label="Boundary"
      value={keepBoundary ? [FIXED, form].join(" ").trim() : form}
      words={words}
      onChoose={(chosen) => {
        const fixed = chosen.startsWith(FIXED);
        const wanted = fixed ? chosen.slice(FIXED.length).trim() : chosen;
        void commitSettings(page, {
          keepBoundary: fixed,
          supports: withBoundary(supports, wanted),
        });
      }}
    />
  );
}

export function ReachAndSoftness() {
  return (
    <>
      <Reach />
      <Softness />
      <UnderSoftness />
      <Boundary />
    </>
  );
}
