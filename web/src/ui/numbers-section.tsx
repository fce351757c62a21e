// SPDX-License-Identifier: MIT
// The numbers of panels and points, as tables and reports give them, on the model.
import { useEffect } from "preact/hooks";
import { followNumbers } from "../scene/number-follower.ts";
import { numbered, toggleNumbers } from "../state/numbering.ts";
import { Ask } from "./ask.tsx";
import { NUMBERS } from "./commands/view-commands.ts";
import "./numbers.css";
import { usePage } from "./page-context.ts";
import { viewOf } from "./view-slot.ts";

export function NumbersSection() {
  const page = usePage();
  useEffect(() => {
    const view = viewOf(page);
    return view ? followNumbers(page, view) : undefined;
  }, []);
  return (
    <section class="step" aria-labelledby="numbers">
      <h2 id="numbers">Numbers</h2>
      <Ask about="numbers" />
      {NUMBERS.map(([of, label]) => (
        <label key={of} class="check">
          <input
            type="checkbox"
            checked={numbered(page).value[of]}
            onChange={() => toggleNumbers(page, of)}
          />
          <span>{label}</span>
        </label>
      ))}
    </section>
  );
}
