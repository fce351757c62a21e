// SPDX-License-Identifier: MIT
// What changes the view and not the design, beside the buttons of the view: it stays open while the view is used.
import { useRef } from "preact/hooks";
import { cleanView } from "../state/clean-view.ts";
import { viewOptionsShown } from "../state/inspector.ts";
import { sectionPlane } from "../state/shown-section.ts";
import { usePage } from "./page-context.ts";
import { ViewSections } from "./places.ts";

export function ViewOptions() {
  const page = usePage();
  const shown = viewOptionsShown(page);
  const changed = sectionPlane(page).value !== null || cleanView(page).value;
  const button = useRef<HTMLButtonElement>(null);
  return (
    <div class="view-options">
      <section
        id="view-options"
        class="view-options-panel"
        aria-label="View options"
        hidden={!shown.value}
        onKeyDown={(event) => {
          if (event.key !== "Escape") return;
          event.stopPropagation();
          shown.value = false;
          button.current?.focus();
        }}
      >
        <ViewSections />
      </section>
      <button
        ref={button}
        type="button"
        class={changed ? "view-options-button on" : "view-options-button"}
        title="Clean view, section, numbers of panels and points, named views"
        aria-expanded={shown.value}
        aria-controls="view-options"
        onClick={() => {
          shown.value = !shown.value;
        }}
      >
        View options
      </button>
    </div>
  );
}
