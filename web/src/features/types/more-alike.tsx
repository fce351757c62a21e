// SPDX-License-Identifier: MIT

import { useSignal } from "@preact/signals";
import { Check } from "../../ui/check.tsx";
import { LimitField } from "../../ui/limit-field.tsx";
import { usePage } from "../../ui/page-context.ts";
import { type AlikeChoice, makeAlike } from "./more-alike.ts";

/** Shares of the mean edge. */
const MOVES: readonly (readonly [number, string])[] = [
  [0.05, "5 % of an edge"],
  [0.1, "10 % of an edge"],
  [0.2, "20 % of an edge"],
];

/** What may move so that there are fewer types. */
export function MoreAlike() {
  const page = usePage();
  const choice = useSignal<AlikeChoice>({ types: 0, move: 0.1, keepBoundary: true });
  const change = (changed: Partial<AlikeChoice>): void => {
    choice.value = { ...choice.value, ...changed };
  };
  const { types, move, keepBoundary } = choice.value;
  return (
    <details class="types-choice">
      <summary>Make more alike</summary>
      <label>
        Moves up to{" "}
        <select
          class="select"
          value={String(move)}
          onChange={({ currentTarget }) => change({ move: Number(currentTarget.value) })}
        >
          {MOVES.map(([share, words]) => (
            <option key={share} value={String(share)}>
              {words}
            </option>
          ))}
        </select>
      </label>
      <div class="types-most">
        Types at most
        <LimitField
          label="Types at most"
          about="Empty: as few as are found with corners within what is chosen above"
          value={types}
          unit={null}
          zero="any number"
          invalid={types < 0 || !Number.isInteger(types)}
          onApply={(value) => change({ types: value })}
        />
      </div>
      <Check
        label="The boundary stays"
        checked={keepBoundary}
        onChange={(on) => change({ keepBoundary: on })}
      />
      <button
        type="button"
        class="button small"
        title="Another mesh, flat and sound, with fewer types: folds at most 5° sharper, or as your limits say"
        disabled={!page.ready.value || page.busy.value || types < 0 || !Number.isInteger(types)}
        onClick={() => void makeAlike(page, choice.value)}
      >
        Find fewer types
      </button>
    </details>
  );
}
