// SPDX-License-Identifier: MIT
import { explore } from "../state/exploring.ts";
import { fetchPart } from "../state/later.ts";
import { dimension, draft, eigenbasis, figures, ready } from "../state/store.ts";
import { later } from "./later.tsx";
import { Slider } from "./slider.tsx";

const VariationSliders = later(() =>
  import("./variation-sliders.tsx").then((part) => part.VariationSliders),
);
const VariationGallery = later(() =>
  import("./variation-gallery.tsx").then((part) => part.VariationGallery),
);

const ContinueButton = later(() =>
  import("./continue-button.tsx").then((part) => part.ContinueButton),
);

const directions = (count: number): string =>
  `${count} ${count === 1 ? "direction" : "directions"}`;

async function exploreAndShow(): Promise<void> {
  await explore();
  // The sliders and the gallery are what was asked for.
  if (draft.value?.variation)
    document.getElementById("step-explore")?.parentElement?.scrollIntoView();
  const part = await fetchPart(() => import("../state/gallery.ts"));
  await part?.fillGallery();
}

/** Step 2: a few sliders around the edit that act instantly, and designs to choose from. */
export function ExploreSection() {
  const possible = ready.value && figures.value.movedVertices > 0;
  return (
    <section class="step explore-step" aria-labelledby="step-explore">
      <h2 id="step-explore">
        <span class="step-number">2</span> Explore
      </h2>
      <p class="quiet">
        Variations of the edit that keep every panel flat, and circular or conical where the edit
        does. Most stay about it; some also move points elsewhere, as the colours show.
      </p>
      <Slider
        label="Dimension"
        value={dimension.value}
        min={1}
        max={12}
        step={1}
        spoken={directions(dimension.value)}
        ends={["one slider", "twelve sliders"]}
        disabled={!ready.value}
        onInput={(value) => {
          dimension.value = value;
        }}
        onCommit={(value) => {
          dimension.value = value;
        }}
      />
      <label class="check">
        <input
          type="checkbox"
          checked={eigenbasis.value}
          aria-describedby="first-directions"
          disabled={!ready.value}
          onChange={({ currentTarget }) => {
            eigenbasis.value = currentTarget.checked;
          }}
        />
        <span>Smoothest first</span>
      </label>
      <p id="first-directions" class="quiet small">
        Each slider is one way to change the edit. The first one moves the fewest points, or with
        Smoothest first bends the surface least.
      </p>
      <button
        type="button"
        class={`button wide${possible && !draft.value?.variation ? " primary" : ""}`}
        disabled={!possible}
        onClick={() => void exploreAndShow()}
      >
        Find variations
      </button>
      <VariationSliders />
      <ContinueButton />
      <VariationGallery />
    </section>
  );
}
