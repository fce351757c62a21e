// SPDX-License-Identifier: MIT
import { commitVariation, previewVariation } from "../state/exploring.ts";
import { reachOf } from "../state/reach.ts";
import { draft, mesh, unit } from "../state/store.ts";
import { formatLength } from "../state/units.ts";
import { Slider } from "./slider.tsx";

/** One slider for each direction that was found around the edit. */
export function VariationSliders() {
  const variation = draft.value?.variation;
  const base = mesh.value?.positions;
  if (!variation || !base) return null;
  const reach = reachOf(variation.centre, base);
  const found = variation.coefficients.length;
  const words = (x: number): string =>
    `${x > 0 ? "+" : x < 0 ? "−" : ""}${formatLength(Math.abs(x) * reach, unit.value)}`;
  return (
    <>
      <p class="quiet small">
        {found < variation.asked && `${found} of ${variation.asked} directions exist here. `}
        At either end of a slider the point that moves most moves by{" "}
        {formatLength(reach, unit.value)}.
      </p>
      {variation.coefficients.map((value, k) => {
        const label = `Variation ${k + 1}`;
        return (
          <Slider
            key={label}
            label={label}
            value={value}
            min={-1}
            max={1}
            step={0.01}
            shown={words(value)}
            disabled={false}
            onInput={(x) => previewVariation(k, x)}
            onCommit={(x, burst) => commitVariation(k, x, burst)}
          />
        );
      })}
    </>
  );
}
