// SPDX-License-Identifier: MIT

import { flatnessWords, isFlat } from "../../design/flatness.ts";
import { damage, damageWords } from "../../state/damage.ts";
import { countHealth } from "../../state/panel-rows.ts";
import { usePage } from "../../ui/page-context.ts";

const panelsCross = (count: number): string =>
  count === 1 ? "1 panel crosses itself" : `${count} panels cross themselves`;

/** Whether every panel can be made: being flat is not all. */
export function Verdict() {
  const page = usePage();
  const { worstGap, worstMmPerM, worstExcess } = page.figures.value;
  const exact = isFlat(page.figures.value);
  const crossing = page.panelHealth.value ? countHealth(page.panelHealth.value).crossing : 0;
  const done = damage(page).value;
  const spoilt = done ? damageWords(done, page.panelHealth.value) : "";
  const sound = crossing === 0 && spoilt === "";
  const { sentence } = flatnessWords(worstGap, worstMmPerM, worstExcess, page.unit.value);
  return (
    <p class={exact && sound ? "verdict good" : "verdict"}>
      {`${exact ? "Every panel is" : "Worst panel"} ${sentence}.`}
      {spoilt && ` But ${spoilt} since the mesh was opened.`}
      {!spoilt && crossing > 0 && ` But ${panelsCross(crossing)}, as in the file.`}
    </p>
  );
}
