// SPDX-License-Identifier: MIT
// What lies over the view, or is read aloud of it, once the page can be used.

import { HiddenNote } from "../features/hiding/hiding-controls.tsx";
import { ReceivedNote } from "../features/notes/note-section.tsx";
import { OffsetNote } from "../features/second-layer/offset-note.tsx";
import { FingerOffer } from "../features/touch/finger-offer.tsx";
import { fingerDrag } from "../state/finger-drag.ts";
import { hiddenPanels } from "../state/hidden-panels.ts";
import type { Page } from "../state/page.ts";
import { arrivedNote } from "../state/receiving.ts";
import { usePage } from "./page-context.ts";
import { meaning } from "./point-figure.tsx";

function selectionWords(page: Page): string {
  const vertex = page.selected.value;
  const count = page.selection.value.length;
  if (vertex === null) return "";
  const offer = fingerDrag(page).value ? ". Keep it, or take it back" : "";
  if (count > 1) return `${count} points selected, the last is point ${vertex}${offer}`;
  const row = page.handles.value.find((one) => one.vertex === vertex);
  const kind = row ? (row.pinned ? ", pinned" : ", a handle") : "";
  return `Point ${vertex} selected${kind}, ${meaning(page, vertex)}${offer}`;
}

/** Says what is selected to those who do not see it. */
function Announcement() {
  const page = usePage();
  return (
    <p class="visually-hidden" aria-live="polite">
      {selectionWords(page)}
    </p>
  );
}

export { SightTools } from "../features/hiding/hiding-controls.tsx";

export function ViewNotes() {
  const page = usePage();
  return (
    <>
      <Announcement />
      {arrivedNote(page).value && <ReceivedNote />}
      <FingerOffer />
      {page.offsetChoice.value && <OffsetNote />}
      {hiddenPanels(page).value.size > 0 && <HiddenNote />}
    </>
  );
}
