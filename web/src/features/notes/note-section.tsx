// SPDX-License-Identifier: MIT
// A note to whoever gets the design.
import { LONGEST_NOTE } from "../../design/companions.ts";
import { note } from "../../state/note.ts";
import { usePage } from "../../ui/page-context.ts";
import "./note.css";
import { Ask } from "../../ui/ask.tsx";

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
