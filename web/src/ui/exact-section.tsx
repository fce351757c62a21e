// SPDX-License-Identifier: MIT
import { makeExact } from "../state/exploring.ts";
import { isFlat } from "../state/flatness.ts";
import { figures, mesh, ready, showBefore } from "../state/store.ts";
import { later } from "./later.tsx";

const Verdict = later(() => import("./verdict.tsx").then((part) => part.Verdict));
const PanelsTable = later(() => import("./panels-table.tsx").then((part) => part.PanelsTable));

function hold(on: boolean): void {
  showBefore.value = on;
}

/** Step 3: project what is shown onto exactly flat panels, and judge the result. */
export function ExactSection() {
  const exact = isFlat(figures.value);
  return (
    <section class="step" aria-labelledby="step-exact">
      <h2 id="step-exact">
        <span class="step-number">3</span> Make exact
      </h2>
      <Verdict />
      <div class="row">
        <button
          type="button"
          class={`button grow${exact ? "" : " primary"}`}
          disabled={!ready.value}
          onClick={() => void makeExact()}
        >
          Make exact
        </button>
        <button
          type="button"
          class="button"
          aria-pressed={showBefore.value}
          title="Hold to see the design before the edit (B)"
          disabled={!mesh.value}
          onPointerDown={() => hold(true)}
          onPointerUp={() => hold(false)}
          onPointerLeave={() => hold(false)}
          onKeyDown={(event) => event.key === " " && hold(true)}
          onKeyUp={() => hold(false)}
        >
          Before
        </button>
      </div>
      <PanelsTable />
    </section>
  );
}
