// SPDX-License-Identifier: MIT

import { isFlat } from "../../design/flatness.ts";
import { damage, damageWords, spoiltPanels } from "../../state/damage.ts";
import { showNextPanel } from "../../state/selection.ts";
import { usePage } from "../../ui/page-context.ts";

/** That flat panels are spoilt all the same, and the way to each of them. */
export function DamageNote() {
  const page = usePage();
  const found = damage(page).value;
  const words = found && damageWords(found, page.panelHealth.value);
  if (!words) return null;
  const flat = isFlat(page.figures.value);
  return (
    <>
      {"· "}
      <button
        type="button"
        class="text-button"
        title="Go to the next of these panels"
        onClick={() => showNextPanel(page, spoiltPanels(found))}
      >
        {`${flat ? "flat, but " : ""}${words}: show`}
      </button>
    </>
  );
}
