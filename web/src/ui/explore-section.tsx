// SPDX-License-Identifier: MIT
import { commitVariation, explore, previewVariation } from "../state/exploring.ts";
import { dimension, draft, figures, ready } from "../state/store.ts";
import { Slider } from "./slider.tsx";

function Variations() {
  const variation = draft.value?.variation;
  if (!variation) return null;
  return (
    <>
      {variation.coefficients.map((value, k) => {
        const label = `Variation ${k + 1}`;
        return (
          <Slider
            key={label}
            label={label}
            value={value}
            min={-1}
            max={1}
            step={0.01}
            shown={value.toFixed(2)}
            disabled={false}
            onInput={(x) => previewVariation(k, x)}
            onCommit={(x) => void commitVariation(k, x)}
          />
        );
      })}
    </>
  );
}

/** Step 2: a few sliders around the edit that act instantly. */
export function ExploreSection() {
  const possible = ready.value && figures.value.movedVertices > 0;
  return (
    <section class="step" aria-labelledby="step-explore">
      <h2 id="step-explore">
        <span class="step-number">2</span> Explore
      </h2>
      <p class="quiet">Variations of the edit that keep every panel flat and stay in its place.</p>
      <Slider
        label="Dimension"
        value={dimension.value}
        min={1}
        max={12}
        step={1}
        disabled={!ready.value}
        onInput={(value) => {
          dimension.value = value;
        }}
        onCommit={(value) => {
          dimension.value = value;
        }}
      />
      <button
        type="button"
        class={`button wide${possible && !draft.value?.variation ? " primary" : ""}`}
        disabled={!possible}
        onClick={() => void explore()}
      >
        Find variations
      </button>
      <Variations />
    </section>
  );
}
