// SPDX-License-Identifier: MIT

import { cleanView, toggleCleanView } from "../../state/clean-view.ts";
import { Check } from "../../ui/check.tsx";
import { usePage } from "../../ui/page-context.ts";

export function CleanSection() {
  const page = usePage();
  return (
    <section class="step" aria-labelledby="clean-view">
      <h2 id="clean-view">Clean view</h2>
      <Check
        label="Hide marks, arrows and the reach"
        checked={cleanView(page).value}
        onChange={() => toggleCleanView(page)}
      />
    </section>
  );
}
