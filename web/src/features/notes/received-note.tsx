// SPDX-License-Identifier: MIT
import { arrivedNote } from "../../state/receiving.ts";
import { Icon } from "../../ui/icon.tsx";
import { usePage } from "../../ui/page-context.ts";
import "./note.css";

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
        aria-label="Put the note aside"
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
