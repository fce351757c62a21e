// SPDX-License-Identifier: MIT
import { damage, damageWords, spoiltPanels } from "../state/damage.ts";
import { isFlat } from "../state/flatness.ts";
import { showNextPanel } from "../state/selection.ts";
import { figures, panelHealth } from "../state/store.ts";

/** That flat panels are spoilt all the same, and the way to each of them. */
export function DamageNote() {
  const found = damage.value;
  const words = found && damageWords(found, panelHealth.value);
  if (!words) return null;
  const flat = isFlat(figures.value);
  return (
    <>
      {"· "}
      <button
        type="button"
        class="text-button"
        title="Go to the next of these panels"
        onClick={() => showNextPanel(spoiltPanels(found))}
      >
        {`${flat ? "flat, but " : ""}${words}: show`}
      </button>
    </>
  );
}
