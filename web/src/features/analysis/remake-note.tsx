// SPDX-License-Identifier: MIT

import { damage } from "../../state/damage.ts";
import { countHealth } from "../../state/panel-rows.ts";
import { usePage } from "../../ui/page-context.ts";

/** How many panels the shop makes again after a finished edit, and the way to see which. */
export function RemakeNote() {
  const page = usePage();
  // Measured together: while there is no word on the damage, health is that of an earlier design.
  const health = damage(page).value && page.panelHealth.value;
  const { changed } = health ? countHealth(health) : { changed: 0 };
  if (changed === 0) return null;
  return (
    <button
      type="button"
      class="text-button remake-note"
      title="Colour by what must be made again"
      onClick={() => {
        page.colourBy.value = "remake";
      }}
    >
      {`${changed} ${changed === 1 ? "panel" : "panels"} to make again`}
    </button>
  );
}
