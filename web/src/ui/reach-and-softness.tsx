// SPDX-License-Identifier: MIT
// How far an edit may reach and how softly it bends, with what each of them does at once.

import { FIRST_SETTINGS } from "../design/design.ts";
import { boundaryForm, withBoundary } from "../design/supports.ts";
import { formatLength } from "../quantity/units.ts";
import { commitSettings, previewSettings } from "../state/editing.ts";
import { foldWords } from "../state/fold.ts";
import { Ask } from "./ask.tsx";
import { Choice } from "./choice.tsx";
import { later } from "./later.tsx";
import { usePage } from "./page-context.ts";
import { Slider } from "./slider.tsx";

const MOST_RINGS = 12;
/** One step beyond the most rings. */
const NO_LIMIT = MOST_RINGS + 1;
/** The core's kHardest and kSoftest; at 0 the raw weights hold. */
const [HARDEST, SOFTEST] = [1, 10];

const ringWords = (rings: number): string => (rings === 1 ? "1 panel" : `${rings} panels`);

/** What a slider does to the design on screen; "" without an edit. */
function Effect({ words }: { words: string }) {
  return <p class="quiet small effect">{words}</p>;
}

const movedWords = (moved: number): string => {
  if (moved === 0) return "";
  return moved === 1 ? "1 point moves" : `${moved} points move`;
};

function Reach() {
  const page = usePage();
  const { reach, reachLength } = page.settings.value ?? FIRST_SETTINGS;
  const limits = [
    ...(reach > 0 ? [ringWords(reach)] : []),
    ...(reachLength > 0 ? [formatLength(reachLength, page.unit.value)] : []),
  ];
  const shown = limits.join(", ") || "no limit";
  const change = (value: number) => ({
    reach: value === NO_LIMIT ? 0 : value,
    reachLength: 0,
  });
  return (
    <Slider
      label="Reach"
      aside={<Ask about="reach" />}
      value={reach === 0 ? NO_LIMIT : Math.min(reach, MOST_RINGS)}
      min={1}
      max={NO_LIMIT}
      step={1}
      shown={shown}
      disabled={!page.ready.value}
      ends={["next panels only", "no limit"]}
      onInput={(value) => previewSettings(page, change(value))}
      onCommit={(value, burst) => commitSettings(page, change(value), burst)}
    />
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
      aside={<Ask about="softness" />}
      value={Math.max(softness, HARDEST)}
      min={HARDEST}
      max={SOFTEST}
      step={1}
      shown={shown}
      spoken={softness > 0 ? `${shown} of ${SOFTEST}` : shown}
      disabled={!page.ready.value}
      ends={["close and firm", "wide and gentle"]}
      onInput={(value) => previewSettings(page, change(value))}
      onCommit={(value, burst) => commitSettings(page, change(value), burst)}
    />
  );
}

function KeepBoundary() {
  const page = usePage();
  const { keepBoundary } = page.settings.value ?? FIRST_SETTINGS;
  return (
    <>
      <div class="beside">
        <label class="check">
          <input
            type="checkbox"
            checked={keepBoundary}
            disabled={!page.ready.value}
            onChange={({ currentTarget }) =>
              void commitSettings(page, { keepBoundary: currentTarget.checked })
            }
          />
          <span>Keep boundary</span>
        </label>
        <Ask about="boundary" />
      </div>
      <p class="quiet small">The points that you drag move all the same.</p>
    </>
  );
}

const FewPanels = later(() =>
  import("../features/few-panels/few-panels.tsx").then((part) => part.FewPanels),
);

const PointSupports = later(() =>
  import("../features/supports/point-supports.tsx").then((part) => part.PointSupports),
);

const KeepOuts = later(() =>
  import("../features/keep-outs/keep-outs-section.tsx").then((part) => part.KeepOuts),
);

const SymmetrySection = later(() =>
  import("../features/symmetry/symmetry-section.tsx").then((part) => part.SymmetrySection),
);

const SLIDES: readonly (readonly [string, string])[] = [
  ["", "moves freely"],
  ["level=z", "keeps its level"],
  ["outline", "stays on its outline"],
  ["surface", "stays on the surface"],
];

/** What boundary points do that move: those that are dragged, and all where the boundary is not kept. */
function BoundarySlides() {
  const page = usePage();
  const { supports } = page.settings.value ?? FIRST_SETTINGS;
  return (
    <Choice
      label="Boundary that moves"
      value={boundaryForm(supports)}
      words={SLIDES}
      onChoose={(form) => void commitSettings(page, { supports: withBoundary(supports, form) })}
    />
  );
}

export function ReachAndSoftness() {
  const page = usePage();
  return (
    <>
      <Reach />
      <Effect words={movedWords(page.figures.value.movedVertices)} />
      <Softness />
      <Effect words={foldWords(page.figures.value)} />
      <FewPanels />
      <KeepBoundary />
      <BoundarySlides />
      <PointSupports />
      <KeepOuts />
      <SymmetrySection />
    </>
  );
}
