// SPDX-License-Identifier: MIT

import { counted } from "../quantity/counted.ts";
import { CommandButton } from "./command-button.tsx";
import { COMMANDS } from "./commands/commands.ts";
import { later } from "./later.tsx";
import { usePage } from "./page-context.ts";
import { Slider } from "./slider.tsx";

const VariationSliders = later(() =>
  import("../features/exploring/variation-sliders.tsx").then((part) => part.VariationSliders),
);

const VariationGallery = later(() =>
  import("../features/exploring/variation-gallery.tsx").then((part) => part.VariationGallery),
);

const ContinueButton = later(() =>
  import("../features/exploring/continue-button.tsx").then((part) => part.ContinueButton),
);

/** A few sliders around the edit that act instantly, and designs to choose from. */
export function ExploreSection() {
  const page = usePage();
  const possible = page.ready.value && page.figures.value.movedVertices > 0;
  // The sliders need the room, and say more.
  const varied = Boolean(page.draft.value?.variation);
  return (
    <section
      class={varied ? "step explore-step varied" : "step explore-step"}
      aria-labelledby="step-explore"
    >
      <h2 id="step-explore" class="visually-hidden">
        Explore
      </h2>
      <p class={varied ? "visually-hidden" : "quiet"}>
        Variations of the edit that keep every panel flat, and circular or conical where the edit
        does. Most stay about it; some also move points elsewhere, as the colours show.
      </p>
      <Slider
        label="Number of sliders"
        value={page.dimension.value}
        min={1}
        max={12}
        step={1}
        spoken={counted(page.dimension.value, "direction")}
        ends={["one", "twelve"]}
        disabled={!page.ready.value}
        onInput={(value) => {
          page.dimension.value = value;
        }}
        onCommit={(value) => {
          page.dimension.value = value;
        }}
      />
      <label class="check">
        <input
          type="checkbox"
          checked={page.eigenbasis.value}
          aria-describedby="first-directions"
          disabled={!page.ready.value}
          onChange={({ currentTarget }) => {
            page.eigenbasis.value = currentTarget.checked;
          }}
        />
        <span>Smoothest slider first</span>
      </label>
      <p id="first-directions" class={varied ? "visually-hidden" : "quiet small"}>
        Each slider is one way to change the edit. The first one moves the fewest points, or with
        Smoothest slider first bends the surface least.
      </p>
      <CommandButton
        look={possible && !varied ? "button wide primary" : "button wide"}
        command={COMMANDS.findVariations}
      />
      <VariationSliders />
      <ContinueButton />
      <VariationGallery />
    </section>
  );
}
