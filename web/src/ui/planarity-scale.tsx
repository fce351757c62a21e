// SPDX-License-Identifier: MIT
import "./legend-scales.css";
import { FABRICATION_LIMIT, planarityShare } from "../scene/ramp.ts";

/** mm/m. Where there is little room only the main ones are named. */
const DECADES: readonly (readonly [value: number, main: boolean])[] = [
  // Below a thousandth there is no room for words.
  [0.00001, false],
  [0.0001, false],
  [0.001, true],
  [0.01, false],
  [0.1, true],
  [1, false],
  [FABRICATION_LIMIT, true],
];

const place = (value: number): string => `${100 * planarityShare(value)}%`;

/** Ticks at powers of ten below the ramp: its colours are not in proportion to the figures. */
export function PlanarityScale() {
  return (
    <>
      <div class="decades" aria-hidden="true">
        <span class="decade flat">flat</span>
        {DECADES.map(([value, main]) => (
          <span
            key={value}
            class={`decade${main ? "" : " minor"}${value === FABRICATION_LIMIT ? " last" : ""}`}
            style={{ "--place": place(value) }}
          >
            {value < 0.001 ? "" : value}
          </span>
        ))}
      </div>
      <p class="scale-words">
        mm/m, logarithmic
        <span class="visually-hidden"> scale, from flat to {FABRICATION_LIMIT} mm/m or more</span>
      </p>
    </>
  );
}
