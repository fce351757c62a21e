// SPDX-License-Identifier: MIT
// The numbers of panels and points, as tables and reports give them, on the model.

import { useEffect } from "preact/hooks";
import { Ask } from "../../ui/ask.tsx";
import { Check } from "../../ui/check.tsx";
import { followNumbers } from "./number-follower.ts";
import { NUMBERS, numbered, toggleNumbers } from "./numbering.ts";
import "./numbers.css";
import { usePage } from "../../ui/page-context.ts";
import { viewOf } from "../../ui/view-slot.ts";

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
        <Check
          key={of}
          label={label}
          checked={numbered(page).value[of]}
          onChange={() => toggleNumbers(page, of)}
        />
      ))}
    </section>
  );
}
