// SPDX-License-Identifier: MIT
// How an opened mesh becomes flat: close to what was opened, or fair.
import { planarising, ready } from "../state/store.ts";
import { Slider } from "./slider.tsx";

/** Weights of fairness, from the nearest flat mesh to the fairest. */
const STOPS = [0, 1, 10, 100, 1000] as const;
const NAMES = ["nearest", "close", "fair", "fairer", "fairest"] as const;

/** The stop for a weight that may have come from elsewhere. */
const stopOf = (smooth: number): number => {
  const next = STOPS.findIndex((weight) => weight >= smooth);
  return next < 0 ? STOPS.length - 1 : next;
};

const choose = (stop: number): void => {
  planarising.value = { ...planarising.value, smooth: STOPS[stop] ?? 0 };
};

export function PlanariseChoice() {
  const { smooth, keepBoundary } = planarising.value;
  const stop = stopOf(smooth);
  const name = NAMES[stop] ?? "";
  return (
    <>
      <Slider
        label="Close or fair"
        value={stop}
        min={0}
        max={STOPS.length - 1}
        step={1}
        shown={name}
        spoken={name}
        disabled={!ready.value}
        ends={["close to the file", "fair folds"]}
        onInput={choose}
        onCommit={choose}
      />
      <label class="check">
        <input
          type="checkbox"
          checked={keepBoundary}
          onChange={({ currentTarget }) => {
            planarising.value = { ...planarising.value, keepBoundary: currentTarget.checked };
          }}
        />
        <span>Keep the boundary where it is</span>
      </label>
    </>
  );
}
