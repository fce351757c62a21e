// SPDX-License-Identifier: MIT
// Which mirror planes and turns of the mesh every edit follows.

import { Check } from "../../ui/check.tsx";
import { LimitField } from "../../ui/limit-field.tsx";
import { usePage } from "../../ui/page-context.ts";
import { findMirrors, mirrors, mostImages, noMirrors, setMirrors } from "./symmetry.ts";
import "../../ui/keep-out-rows.css";
import "./symmetry.css";
import { Ask } from "../../ui/ask.tsx";

const AXES = ["x", "y", "z"] as const;

const replaced = <T,>(list: readonly T[], place: number, by: T): readonly T[] =>
  list.map((one, k) => (k === place ? by : one));

export function SymmetryRule() {
  const page = usePage();
  const { across, turns } = mirrors(page).value;
  const images = mostImages(page).value;
  return (
    <>
      <Ask about="symmetry" />
      <div class="keep-out-kinds">
        <button
          type="button"
          class="tool"
          disabled={!page.ready.value}
          onClick={() => void findMirrors(page)}
        >
          All that it has
        </button>
        <button
          type="button"
          class="tool"
          disabled={!page.ready.value || images === 1}
          onClick={() => void noMirrors(page)}
        >
          None
        </button>
      </div>
      {AXES.map((axis, k) => (
        <div key={axis} class="keep-out-row symmetry-row">
          <Check
            label={`Mirror across ${axis}`}
            checked={across[k] ?? false}
            disabled={!page.ready.value}
            onChange={(on) => void setMirrors(page, { across: replaced(across, k, on), turns })}
          />
          <LimitField
            label={`Turns about ${axis}`}
            about={`that the mesh has about ${axis}; 0 for none`}
            value={turns[k] ?? 0}
            unit={null}
            invalid={false}
            onApply={(given) => void setMirrors(page, { across, turns: replaced(turns, k, given) })}
          />
          <span class="quiet small">turns (0: none)</span>
        </div>
      ))}
      {images > 1 && <p>{`Each point has ${images} images, itself included.`}</p>}
      <p class="quiet">
        What is done to one point is done to all its images, in variations as well.
      </p>
    </>
  );
}
