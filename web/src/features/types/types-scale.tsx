// SPDX-License-Identifier: MIT

import { useEffect } from "preact/hooks";
import { counted } from "../../quantity/counted.ts";
import { formatLength, type Unit } from "../../quantity/units.ts";
import type { ShownTypes } from "../../state/page-state.ts";
import { Check } from "../../ui/check.tsx";
import { NamedPanelsList } from "../../ui/named-panels.tsx";
import { usePage } from "../../ui/page-context.ts";
import "../../ui/legend-scales.css";
import { MoreAlike } from "./more-alike.tsx";
import { colouredTypes, followTypes } from "./types.ts";

/** Shares of the mean edge: what rounding leaves, and what a joint takes up. */
const SHARES: readonly (readonly [number, string])[] = [
  [1e-6, "the same"],
  [0.001, "0.1 % of an edge"],
  [0.005, "0.5 % of an edge"],
  [0.01, "1 % of an edge"],
  [0.02, "2 % of an edge"],
];

/** One that was found is between them. */
const sharesWith = (chosen: number): readonly (readonly [number, string])[] =>
  SHARES.some(([share]) => share === chosen)
    ? SHARES
    : [...SHARES, [chosen, `${(100 * chosen).toPrecision(3)} % of an edge`]];

/** How far panels of one type may be from alike. */
function Choice() {
  const page = usePage();
  const choice = page.typesChoice.value;
  return (
    <div class="types-choice">
      <label>
        Corners within{" "}
        <select
          class="select"
          value={String(choice.share)}
          onChange={({ currentTarget }) => {
            page.typesChoice.value = { ...choice, share: Number(currentTarget.value) };
          }}
        >
          {sharesWith(choice.share).map(([share, words]) => (
            <option key={share} value={String(share)}>
              {words}
            </option>
          ))}
        </select>
      </label>
      <Check
        label="Turned over, too"
        checked={choice.mirrored}
        onChange={(on) => {
          page.typesChoice.value = { ...choice, mirrored: on };
        }}
      />
    </div>
  );
}

/** How many there are, and how far a panel is from its template. */
function Count({ types, unit }: { types: ShownTypes["types"]; unit: Unit }) {
  const [count, panels] = [types.sizes.length, types.ofPanel.length];
  const words = `${counted(count, "type")} of ${panels} panels, corners within ${formatLength(types.worstFit, unit)}`;
  return (
    <p class="legend-note" aria-live="polite">
      {words}
    </p>
  );
}

/** The types of panels, the largest with their colours; each leads to its panels in turn. */
export function TypesScale() {
  const page = usePage();
  useEffect(() => followTypes(page), []);
  const shown = page.shownTypes.value;
  if (!shown) return <Choice />;
  const { types } = shown;
  if (types.problem) return <p class="legend-note">{`Not found: ${types.problem}`}</p>;
  const coloured = colouredTypes(shown);
  return (
    <>
      <Choice />
      <Count types={types} unit={page.unit.value} />
      <NamedPanelsList all={coloured} />
      <MoreAlike />
      {coloured.length < types.sizes.length && (
        <p class="legend-note">{`${types.sizes.length - coloured.length} more without a colour`}</p>
      )}
    </>
  );
}
