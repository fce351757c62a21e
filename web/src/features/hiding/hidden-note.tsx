// SPDX-License-Identifier: MIT
import { counted } from "../../quantity/counted.ts";
import { hiddenPanels } from "../../state/hidden-panels.ts";
import { usePage } from "../../ui/page-context.ts";
import { showAll } from "./hiding.ts";
import "../../ui/offset-note.css";

/** That the view does not show everything, and the way back. */
export function HiddenNote() {
  const page = usePage();
  const { size } = hiddenPanels(page).value;
  if (size === 0) return null;
  return (
    <section class="offset-note" aria-label="Hidden panels">
      <span>{`${counted(size, "panel")} hidden in the view`}</span>
      <button
        type="button"
        class="button small"
        title="Show all (Shift H)"
        onClick={() => showAll(page)}
      >
        Show all
      </button>
    </section>
  );
}
