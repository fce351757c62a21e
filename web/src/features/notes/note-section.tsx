// SPDX-License-Identifier: MIT
// A note to whoever gets the design.

import { LONGEST_NOTE } from "../../design/companions.ts";
import { note } from "../../state/note.ts";
import { arrivedNote } from "../../state/receiving.ts";
import { Ask } from "../../ui/ask.tsx";
import { Icon } from "../../ui/icon.tsx";
import { usePage } from "../../ui/page-context.ts";
import "./note.css";

export function NoteSection() {
  const page = usePage();
  const written = note(page);
  return (
    <section class="step" aria-labelledby="note">
      <h2 id="note">Note</h2>
      <Ask about="note" />
      <textarea
        class="note-text"
        aria-labelledby="note"
        aria-description="Goes along with links and saved designs"
        placeholder="Goes along with links and saved designs"
        rows={3}
        maxLength={LONGEST_NOTE}
        value={written.value}
        onChange={({ currentTarget }) => {
          written.value = currentTarget.value;
        }}
      />
    </section>
  );
}

/** What the author of a design says of it, until it is put aside; it stays under Note. */
export function ReceivedNote() {
  const page = usePage();
  const arrived = arrivedNote(page);
  if (!arrived.value) return null;
  return (
    <section class="received-note" aria-label="Note that came with the design">
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: a long one scrolls, by keys too */}
      <p tabIndex={0}>{arrived.value}</p>
      <button
        type="button"
        class="icon-button"
        aria-label="Dismiss the note"
        title="It stays at the end of the panel, under Note"
        onClick={() => {
          arrived.value = "";
        }}
      >
        <Icon name="close" />
      </button>
    </section>
  );
}
