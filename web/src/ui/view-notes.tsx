// SPDX-License-Identifier: MIT
// What lies over the view, or is read aloud of it, once the page can be used.
import { hiddenPanels } from "../state/hidden-panels.ts";
import { arrivedNote } from "../state/receiving.ts";
import { Announcement } from "./announcement.tsx";
import { FingerOffer } from "./finger-offer.tsx";
import { HiddenNote } from "./hidden-note.tsx";
import { later } from "./later.tsx";
import { OffsetNote } from "./offset-note.tsx";
import { usePage } from "./page-context.ts";

const ReceivedNote = later(() => import("./received-note.tsx").then((part) => part.ReceivedNote));

export { SightTools } from "./sight-tools.tsx";

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
