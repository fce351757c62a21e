// SPDX-License-Identifier: MIT
// How far an edit may reach and how softly it bends: in place of weights, for most.
import { DEFAULT_SETTINGS } from "../state/design.ts";
import { commitSettings, previewSettings } from "../state/editing.ts";
import { ready, settings, unit } from "../state/store.ts";
import { formatLength } from "../state/units.ts";
import { Slider } from "./slider.tsx";

const MOST_RINGS = 12;
/** The core's kSoftest; below 1 the two weights hold. */
const SOFTEST = 10;

const ringWords = (rings: number): string => (rings === 1 ? "1 panel" : `${rings} panels`);

function Reach() {
  const { reach, reachLength } = settings.value ?? DEFAULT_SETTINGS;
  const limits = [
    ...(reach > 0 ? [ringWords(reach)] : []),
    ...(reachLength > 0 ? [formatLength(reachLength, unit.value)] : []),
  ];
  const shown = limits.join(", ") || "no limit";
  return (
    <Slider
      label="Reach"
      value={Math.min(reach, MOST_RINGS)}
      min={0}
      max={MOST_RINGS}
      step={1}
      shown={shown}
      spoken={reach > 0 ? shown : `0 panels: ${shown}`}
      disabled={!ready.value}
      ends={["no limit", "up to 12 panels away"]}
      onInput={(value) => previewSettings({ reach: value, reachLength: 0 })}
      onCommit={(value, burst) => commitSettings({ reach: value, reachLength: 0 }, burst)}
    />
  );
}

function Softness() {
  const { softness } = settings.value ?? DEFAULT_SETTINGS;
  const shown = softness > 0 ? softness.toFixed(0) : "by the weights";
  return (
    <Slider
      label="Softness"
      value={softness}
      min={0}
      max={SOFTEST}
      step={1}
      shown={shown}
      spoken={softness > 0 ? `${shown} of ${SOFTEST}` : `0 of ${SOFTEST}: ${shown}`}
      disabled={!ready.value}
      ends={["by the weights below", "wide and gentle"]}
      onInput={(value) => previewSettings({ softness: value })}
      onCommit={(value, burst) => commitSettings({ softness: value }, burst)}
    />
  );
}

export function ReachAndSoftness() {
  const { keepBoundary } = settings.value ?? DEFAULT_SETTINGS;
  return (
    <>
      <Reach />
      <Softness />
      <label class="check">
        <input
          type="checkbox"
          checked={keepBoundary}
          disabled={!ready.value}
          onChange={({ currentTarget }) =>
            void commitSettings({ keepBoundary: currentTarget.checked })
          }
        />
        <span>Keep boundary</span>
      </label>
    </>
  );
}
