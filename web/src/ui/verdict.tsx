// SPDX-License-Identifier: MIT
import { damage, damageWords } from "../state/damage.ts";
import { flatnessWords, isFlat } from "../state/flatness.ts";
import { countHealth } from "../state/panel-rows.ts";
import { figures, panelHealth, unit } from "../state/store.ts";

const panelsCross = (count: number): string =>
  count === 1 ? "1 panel crosses itself" : `${count} panels cross themselves`;

/** Whether every panel can be made: being flat is not all. */
export function Verdict() {
  const { worstGap, worstMmPerM, worstExcess } = figures.value;
  const exact = isFlat(figures.value);
  const crossing = panelHealth.value ? countHealth(panelHealth.value).crossing : 0;
  const spoilt = damage.value ? damageWords(damage.value, panelHealth.value) : "";
  const sound = crossing === 0 && spoilt === "";
  const { sentence } = flatnessWords(worstGap, worstMmPerM, worstExcess, unit.value);
  return (
    <p class={exact && sound ? "verdict good" : "verdict"}>
      {`${exact ? "Every panel is" : "Worst panel"} ${sentence}.`}
      {spoilt && ` But ${spoilt} since the mesh was opened.`}
      {!spoilt && crossing > 0 && ` But ${panelsCross(crossing)}, as in the file.`}
    </p>
  );
}
