// SPDX-License-Identifier: MIT
import { countHealth } from "../state/analysis.ts";
import { damage, damageWords } from "../state/damage.ts";
import { makeExact } from "../state/exploring.ts";
import { FLAT, flatnessWords } from "../state/flatness.ts";
import { figures, mesh, panelHealth, ready, showBefore, unit } from "../state/store.ts";
import { later } from "./later.tsx";

const PanelsTable = later(() => import("./panels-table.tsx").then((part) => part.PanelsTable));

function hold(on: boolean): void {
  showBefore.value = on;
}

/** Whether every panel can be made: being flat is not all. */
function Verdict() {
  const { worstGap, worstMmPerM } = figures.value;
  const exact = worstMmPerM <= FLAT;
  const crossing = panelHealth.value ? countHealth(panelHealth.value).crossing : 0;
  const spoilt = damage.value ? damageWords(damage.value) : "";
  const sound = crossing === 0 && spoilt === "";
  const { sentence } = flatnessWords(worstGap, worstMmPerM, unit.value);
  return (
    <p class={exact && sound ? "verdict good" : "verdict"}>
      {`${exact ? "Every panel is" : "Worst panel"} ${sentence}.`}
      {spoilt && ` But ${spoilt} since the mesh was opened.`}
      {!spoilt && crossing > 0 && ` But ${panelsCross(crossing)}, as in the file.`}
    </p>
  );
}

const panelsCross = (count: number): string =>
  count === 1 ? "1 panel crosses itself" : `${count} panels cross themselves`;

/** Step 3: project what is shown onto exactly flat panels, and judge the result. */
export function ExactSection() {
  const exact = figures.value.worstMmPerM <= FLAT;
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
