// SPDX-License-Identifier: MIT
import { useSignal } from "@preact/signals";
import { usePage } from "../../ui/page-context.ts";
import { makeAlike } from "./more-alike.ts";

/** Shares of the mean edge. */
const MOVES: readonly (readonly [number, string])[] = [
  [0.05, "5 % of an edge"],
  [0.1, "10 % of an edge"],
  [0.2, "20 % of an edge"],
];

/** What may move so that there are fewer types. */
export function MoreAlike() {
  const page = usePage();
  const [move, boundary] = [useSignal(0.1), useSignal(true)];
  return (
    <fieldset class="types-choice" aria-label="Make panels alike">
      <label>
        Points may move by{" "}
        <select
          class="select"
          value={String(move.value)}
          onChange={({ currentTarget }) => {
            move.value = Number(currentTarget.value);
          }}
        >
          {MOVES.map(([share, words]) => (
            <option key={share} value={String(share)}>
              {words}
            </option>
          ))}
        </select>
      </label>
      <label class="check">
        <input
          type="checkbox"
          checked={boundary.value}
          onChange={({ currentTarget }) => {
            boundary.value = currentTarget.checked;
          }}
        />
        The boundary stays
      </label>
      <button
        type="button"
        class="button small"
        title="Another mesh, flat and sound, with fewer types: folds at most 5° sharper"
        disabled={!page.ready.value || page.busy.value}
        onClick={() => void makeAlike(page, move.value, boundary.value)}
      >
        Make more alike
      </button>
    </fieldset>
  );
}
