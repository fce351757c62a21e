// SPDX-License-Identifier: MIT
import { commitVariation, explore, previewVariation } from "../state/exploring.ts";
import { fillGallery, gallery } from "../state/gallery.ts";
import { reachOf } from "../state/reach.ts";
import { dimension, draft, eigenbasis, figures, mesh, ready, unit } from "../state/store.ts";
import { formatLength } from "../state/units.ts";
import { later } from "./later.tsx";
import { Slider } from "./slider.tsx";

const VariationGallery = later(() =>
  import("./variation-gallery.tsx").then((part) => part.VariationGallery),
);

const ContinueButton = later(() =>
  import("./continue-button.tsx").then((part) => part.ContinueButton),
);

function Sliders() {
  const variation = draft.value?.variation;
  const base = mesh.value?.positions;
  if (!variation || !base) return null;
  const reach = reachOf(variation.centre, base);
  const found = variation.coefficients.length;
  const words = (x: number): string =>
    `${x > 0 ? "+" : x < 0 ? "−" : ""}${formatLength(Math.abs(x) * reach, unit.value)}`;
  return (
    <>
      <p class="quiet small">
        {found < variation.asked && `${found} of ${variation.asked} directions exist here. `}
        At either end of a slider the point that moves most moves by{" "}
        {formatLength(reach, unit.value)}.
      </p>
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
            shown={words(value)}
            disabled={false}
            onInput={(x) => previewVariation(k, x)}
            onCommit={(x, burst) => commitVariation(k, x, burst)}
          />
        );
      })}
    </>
  );
}

function GalleryButton() {
  const centre = draft.value?.variation?.centre;
  if (!centre || gallery.value?.centre === centre) return null;
  return (
    <button type="button" class="button wide" onClick={() => void fillGallery()}>
      Show gallery
    </button>
  );
}

async function exploreAndShow(): Promise<void> {
  await explore();
  // The sliders and the gallery are what was asked for.
  if (draft.value?.variation)
    document.getElementById("step-explore")?.parentElement?.scrollIntoView();
  await fillGallery();
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
        Variations of the edit that keep every panel flat. Most stay about it; some also move points
        elsewhere, as the colours show.
      </p>
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
      <label class="check">
        <input
          type="checkbox"
          checked={eigenbasis.value}
          disabled={!ready.value}
          onChange={({ currentTarget }) => {
            eigenbasis.value = currentTarget.checked;
          }}
        />
        <span>Smoothest first</span>
      </label>
      <button
        type="button"
        class={`button wide${possible && !draft.value?.variation ? " primary" : ""}`}
        disabled={!possible}
        onClick={() => void exploreAndShow()}
      >
        Find variations
      </button>
      <Sliders />
      <ContinueButton />
      <GalleryButton />
      <VariationGallery />
    </section>
  );
}
