// SPDX-License-Identifier: MIT
import { cleanView, toggleCleanView } from "../../state/clean-view.ts";
import { usePage } from "../../ui/page-context.ts";

export function CleanSection() {
  const page = usePage();
  return (
    <section class="step" aria-labelledby="clean-view">
      <h2 id="clean-view">Clean view</h2>
      <label class="check">
        <input
          type="checkbox"
          checked={cleanView(page).value}
          onChange={() => toggleCleanView(page)}
        />
        <span>Hide marks, arrows and the reach</span>
      </label>
    </section>
  );
}
