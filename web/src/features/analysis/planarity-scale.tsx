// SPDX-License-Identifier: MIT
import { usePage } from "../../ui/page-context.ts";
import "../../ui/legend-scales.css";
import { flatnessWords, isFlat } from "../../design/flatness.ts";
import { measuredPanels } from "../../state/measured-panels.ts";
import { firstPanels } from "../../state/panel-rows.ts";
import { FABRICATION_LIMIT, planarityEnd, planarityShare } from "../../state/ramp-ends.ts";
import { showNextPanel } from "../../state/selection.ts";

/** Power of ten, mm/m, of the first tick; what is flat lies a decade below. */
const FIRST = -5;
/** Smaller figures are too long to be named. */
const FIRST_NAMED = -4;

/** Names stand so far apart, in decades, that they do not touch on a telephone either. */
const apart = (end: number): number => (end > FABRICATION_LIMIT ? 3 : 2);

interface Tick {
  readonly value: number;
  readonly named: boolean;
}

/** Every power of ten up to the ramp's end, which is named. */
function ticksUpTo(end: number): Tick[] {
  const last = Math.round(Math.log10(end));
  return Array.from({ length: last - FIRST + 1 }, (_, k) => {
    const power = FIRST + k;
    const named = power >= FIRST_NAMED && (last - power) % apart(end) === 0;
    return { value: Number(`1e${power}`), named };
  });
}

const WORST = { key: "mmPerM", descending: true, changedOnly: false } as const;

/** The figure itself; it leads to its panel unless every panel is flat. */
function Worst() {
  const page = usePage();
  const { worstGap, worstMmPerM, worstExcess } = page.figures.value;
  const { sentence } = flatnessWords(worstGap, worstMmPerM, worstExcess, page.unit.value);
  const measured = measuredPanels(page).value;
  if (isFlat(page.figures.value) || !measured)
    return <p class="legend-note">{`Worst panel ${sentence}`}</p>;
  const goTo = (): void =>
    showNextPanel(
      page,
      firstPanels(measured, WORST, 1).map(({ panel }) => panel),
    );
  return (
    <button type="button" class="legend-note worst-panel" title="Go to this panel" onClick={goTo}>
      {`Worst panel ${sentence}`}
    </button>
  );
}

/** Ticks at powers of ten below the ramp: its colours are not in proportion to the figures. */
export function PlanarityScale() {
  const page = usePage();
  const end = page.panelFigures.value ? planarityEnd(page.panelFigures.value) : FABRICATION_LIMIT;
  return (
    <>
      <div class="decades" aria-hidden="true">
        <span class="decade flat">flat</span>
        {ticksUpTo(end).map(({ value, named }) => (
          <span
            key={value}
            class={`decade${named ? "" : " minor"}${value === end ? " last" : ""}`}
            style={{ "--place": `${100 * planarityShare(value, end)}%` }}
          >
            {named ? value : ""}
          </span>
        ))}
      </div>
      <p class="scale-words">
        mm/m, logarithmic
        <span class="visually-hidden"> scale, from flat to {end} mm/m or more</span>
      </p>
      <Worst />
    </>
  );
}
