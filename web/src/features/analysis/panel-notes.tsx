// SPDX-License-Identifier: MIT
// What is said of the panels: whether they can be made, what is spoilt, and what must be made again.

import { buildableCorners, newSliver } from "virtual:core-defaults";
import { flatnessWords, isFlat } from "../../design/flatness.ts";
import { limitNumbers } from "../../design/stated-limit.ts";
import { damage, damageWords, spoiltPanels } from "../../state/damage.ts";
import { commitSettings } from "../../state/editing.ts";
import { goToTab } from "../../state/inspector.ts";
import { countHealth } from "../../state/panel-rows.ts";
import { remakeWords } from "../../state/remaking.ts";
import { showNextPanel } from "../../state/selection.ts";
import { usePage } from "../../ui/page-context.ts";

/** Makes the edit again within a limit on corners, where slivers came of an edit without one. */
function AvoidSlivers() {
  const page = usePage();
  const { handles, variation, settings } = page.history.value?.present ?? {};
  const limits = settings?.limits ?? [];
  const hasOwn = limits.some((limit) => limit.startsWith("angle="));
  if (!handles?.length || variation || hasOwn) return null;
  const [low, high] = limitNumbers(buildableCorners);
  return (
    <>
      {" · "}
      <button
        type="button"
        class="text-button"
        title={`Makes the edit again with corners from ${low}° to ${high}°, a limit`}
        disabled={!page.ready.value}
        onClick={() => void commitSettings(page, { limits: [...limits, buildableCorners] })}
      >
        avoid
      </button>
    </>
  );
}

/** Says that flat panels are spoilt all the same, and shows the way to each of them. */
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
        class="text-button alarm"
        title="Go to the next of these panels"
        onClick={() => {
          goToTab(page, "check");
          showNextPanel(page, spoiltPanels(found));
        }}
      >
        {`${flat ? "flat, but " : ""}${words}: show`}
      </button>
      {found.includes(newSliver) && <AvoidSlivers />}
    </>
  );
}

/** How many panels the shop makes again after a finished edit, and the way to see which. */
export function RemakeNote() {
  const page = usePage();
  const words = remakeWords(page);
  if (!words) return null;
  return (
    <button
      type="button"
      class="text-button remake-note"
      title="Colour by what must be made again"
      onClick={() => {
        goToTab(page, "check");
        page.colourBy.value = "remake";
      }}
    >
      {words}
    </button>
  );
}

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
