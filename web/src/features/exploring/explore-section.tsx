// SPDX-License-Identifier: MIT

import { counted } from "../../quantity/counted.ts";
import { goToTab } from "../../state/inspector.ts";
import { CommandButton } from "../../ui/command-button.tsx";
import { usePage } from "../../ui/page-context.ts";
import { Slider } from "../../ui/slider.tsx";
import { ContinueButton } from "./continue-button.tsx";
import { EXPLORING_COMMANDS } from "./exploring-commands.ts";
import { VariationGallery } from "./variation-gallery.tsx";
import { VariationSliders } from "./variation-sliders.tsx";

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
        command={EXPLORING_COMMANDS.findVariations}
      />
      <VariationSliders />
      <ContinueButton />
      <VariationGallery />
    </section>
  );
}

/** What is done after an edit is in the other tabs. */
export function NextSteps() {
  const page = usePage();
  if (!page.ready.value || page.figures.value.movedVertices === 0) return null;
  const { label, run } = EXPLORING_COMMANDS.findVariations;
  return (
    <div class="next-steps">
      <span class="quiet small">Next:</span>
      <button type="button" class="button small" onClick={() => void run(page)}>
        {label}
      </button>
      <button type="button" class="button small" onClick={() => goToTab(page, "check")}>
        Check its panels
      </button>
    </div>
  );
}
