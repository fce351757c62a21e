// SPDX-License-Identifier: MIT
// The way to the tool that cuts where the drag tools have no room for it, and how much was cut.
import { counted } from "../../quantity/counted.ts";
import { refusalOf, titleOf } from "../../ui/commands/command.ts";
import { usePage } from "../../ui/page-context.ts";
import { CUT } from "./cut-button.tsx";
import { cuts } from "./cuts.ts";

export function CutSection() {
  const page = usePage();
  const { length } = cuts(page).value;
  return (
    <section class="step cut-section" aria-labelledby="cuts-made">
      <h2 id="cuts-made">Cuts</h2>
      <p class="quiet small">{length > 0 ? `${counted(length, "cut")} made.` : ""}</p>
      <button
        type="button"
        class="button small"
        title={titleOf(page, CUT)}
        disabled={page.cutting.value || refusalOf(page, CUT) !== ""}
        onClick={() => CUT.run(page)}
      >
        Start cutting
      </button>
    </section>
  );
}
