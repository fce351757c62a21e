// SPDX-License-Identifier: MIT
import { damage } from "../state/damage.ts";
import { countHealth } from "../state/panel-rows.ts";
import { colourBy, panelHealth } from "../state/store.ts";

/** How many panels the shop makes again after a finished edit, and the way to see which. */
export function RemakeNote() {
  // Measured together: while there is no word on the damage, health is that of an earlier design.
  const health = damage.value && panelHealth.value;
  const { changed } = health ? countHealth(health) : { changed: 0 };
  if (changed === 0) return null;
  return (
    <button
      type="button"
      class="text-button remake-note"
      title="Colour by what must be made again"
      onClick={() => {
        colourBy.value = "remake";
      }}
    >
      {`${changed} ${changed === 1 ? "panel" : "panels"} to make again`}
    </button>
  );
}
