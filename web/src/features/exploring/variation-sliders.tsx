// SPDX-License-Identifier: MIT
import { usePage } from "../../ui/page-context.ts";
import "./variation-sliders.css";
import { useEffect } from "preact/hooks";
import type { Variation } from "../../design/design.ts";
import { pointFrame } from "../../mesh/point-frame.ts";
import { formatLength } from "../../quantity/units.ts";
import type { SliderLead, SliderRange } from "../../solver/protocol.ts";
import { shownPoint } from "../../state/editing.ts";
import { visit } from "../../state/selection.ts";
import { sliderLeads } from "../../state/slider-leads.ts";
import { PanelButton } from "../../ui/panel-button.tsx";
import { Slider } from "../../ui/slider.tsx";
import { commitVariation, previewVariation } from "./exploring.ts";
import { reachOf } from "./furthest.ts";
import { leadWords, stopsWithin, wayWords } from "./slider-range.ts";
import { keepStops, sliderRanges } from "./slider-stops.ts";

/** Where and which way a slider moves the structure, seen from the edit that it is around. */
function Lead({ lead, variation }: { lead: SliderLead; variation: Variation }) {
  const page = usePage();
  const opened = page.mesh.value;
  if (!opened) return null;
  const at = (vertex: number) => shownPoint(page, vertex, variation.centre);
  const way = wayWords(lead.move, pointFrame(opened, at, lead.vertex).normal);
  return <>{`To the right point ${lead.vertex} moves most, ${leadWords(lead, way)}. `}</>;
}

function Stop({ panel, side }: { panel: number; side: string }) {
  return (
    <span class="stop-side">
      {`${side} `}
      <PanelButton panel={panel} why=", which stops it" />
    </span>
  );
}

/** Which panels stop a slider, to the left and to the right. */
function Stops({ range, value }: { range: SliderRange; value: number }) {
  const [lower, upper] = stopsWithin(range, 1);
  if (lower === null && upper === null) return null;
  const beyond = value < range.lower || value > range.upper;
  return (
    <span class={beyond ? "beyond" : ""}>
      {beyond ? "Beyond its stop. " : ""}
      {"Stopped by panel "}
      {lower !== null && <Stop panel={range.lowerPanel} side="←" />}
      {lower !== null && upper !== null && ", "}
      {upper !== null && <Stop panel={range.upperPanel} side="→" />}
    </span>
  );
}

/** One slider for each direction that was found around the edit. */
export function VariationSliders() {
  const page = usePage();
  useEffect(() => keepStops(page), []);
  const variation = page.draft.value?.variation;
  const base = page.mesh.value?.positions;
  if (!variation || !base) return null;
  const { centre, coefficients, asked } = variation;
  const reach = reachOf(centre, base);
  const found = coefficients.length;
  const words = (x: number): string =>
    `${x > 0 ? "+" : x < 0 ? "−" : ""}${formatLength(Math.abs(x) * reach, page.unit.value)}`;
  const stops = sliderRanges(page).value;
  const ranges = stops?.centre === centre ? stops.ranges : [];
  const moved = sliderLeads(page).value;
  const leads = moved?.centre === centre ? moved.leads : [];
  return (
    <>
      <p class="quiet small">
        {found < asked && `${found} of ${asked} directions exist here. `}
        Either end moves a point by {formatLength(reach, page.unit.value)}. Hatched: there a panel
        would lose its shape.
      </p>
      {coefficients.map((value, k) => {
        const label = `Variation ${k + 1}`;
        const [range, lead] = [ranges[k], leads[k]];
        const show = (on: boolean) => () => visit(page, on && lead ? lead.vertex : null);
        return (
          <div
            key={label}
            class="variation-slider"
            onPointerEnter={show(true)}
            onPointerLeave={show(false)}
            onFocusIn={show(true)}
            onFocusOut={show(false)}
          >
            <Slider
              label={label}
              value={value}
              min={-1}
              max={1}
              step={0.01}
              shown={words(value)}
              stops={range && stopsWithin(range, 1)}
              disabled={false}
              onInput={(x) => previewVariation(page, k, x)}
              onCommit={(x, burst) => commitVariation(page, k, x, burst)}
            />
            <p class="quiet small slider-about">
              {lead && <Lead lead={lead} variation={variation} />}
              {range && <Stops range={range} value={value} />}
            </p>
          </div>
        );
      })}
    </>
  );
}
