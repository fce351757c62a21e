// SPDX-License-Identifier: MIT
// What lies over the view, or is read aloud of it, once the page can be used.

import { HiddenNote } from "../features/hiding/hidden-note.tsx";
import { OffsetNote } from "../features/second-layer/offset-note.tsx";
import { FingerOffer } from "../features/touch/finger-offer.tsx";
import { hiddenPanels } from "../state/hidden-panels.ts";
import { arrivedNote } from "../state/receiving.ts";
import { Announcement } from "./announcement.tsx";
import { later } from "./later.tsx";
import { usePage } from "./page-context.ts";

const ReceivedNote = later(() =>
  import("../features/notes/received-note.tsx").then((part) => part.ReceivedNote),
);

export { SightTools } from "../features/hiding/sight-tools.tsx";

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
