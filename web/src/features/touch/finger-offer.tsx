// SPDX-License-Identifier: MIT
// Keep or discard what a finger dragged, with the panels that it costs.
import check from "lucide-static/icons/check.svg?raw";
import { discardDrag, fingerDrag, keepDrag, offerPlace } from "../../state/finger-drag.ts";
import type { Page } from "../../state/page.ts";
import { remakeWords } from "../../state/remaking.ts";
import { Drawing, Icon } from "../../ui/icon.tsx";
import { usePage } from "../../ui/page-context.ts";
import { OFFER } from "./clear-of-point.ts";
import "./finger-offer.css";

/** The focus does not go with the buttons. */
function decide(page: Page, what: (page: Page) => unknown): void {
  what(page);
  document.getElementById("view")?.focus({ preventScroll: true });
}

export function FingerOffer() {
  const page = usePage();
  const [drag, place] = [fingerDrag(page).value, offerPlace(page).value];
  if (!drag || !place) return null;
  const { x, y } = place;
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset is for fields
    <div
      class="finger-offer"
      role="group"
      aria-label={`Point ${drag.vertex} was dragged`}
      style={{
        transform: `translate(${x}px, ${y}px)`,
        width: `${OFFER.width}px`,
        height: `${OFFER.height}px`,
      }}
    >
      <p class="quiet small">{remakeWords(page) || "Measuring the panels…"}</p>
      <button type="button" class="button" onClick={() => decide(page, keepDrag)}>
        <Drawing markup={check} />
        Keep
      </button>
      <button type="button" class="button" onClick={() => decide(page, discardDrag)}>
        <Icon name="close" />
        Discard
      </button>
    </div>
  );
}
