// SPDX-License-Identifier: MIT
// The two weights of the paper, for those who want them in place of reach and softness.

import { FIRST_SETTINGS, RAW_WEIGHTS, SOFT_LIMITS } from "../../design/design.ts";
import { commitSettings, previewSettings } from "../../state/editing.ts";
import { usePage } from "../../ui/page-context.ts";
import { Slider } from "../../ui/slider.tsx";

function Weight({ label, weight, ends }: WeightProps) {
  const page = usePage();
  const { softness, [weight]: value } = page.settings.value ?? FIRST_SETTINGS;
  return (
    <Slider
      label={label}
      value={value}
      min={0}
      max={10}
      step={0.1}
      shown={`${value.toFixed(1)} ×`}
      spoken={`${value.toFixed(1)} times the default weight`}
      disabled={!page.ready.value || softness > 0}
      ends={ends}
      onInput={(chosen) => previewSettings(page, { [weight]: chosen })}
      onCommit={(chosen, burst) => commitSettings(page, { [weight]: chosen }, burst)}
    />
  );
}

interface WeightProps {
  readonly label: string;
  readonly weight: "locality" | "smoothness";
  readonly ends: readonly [string, string];
}

export function RawWeights() {
  const page = usePage();
  const { softness } = page.settings.value ?? FIRST_SETTINGS;
  return (
    <>
      <label class="field">
        <span>Bends by</span>
        <select
          class="select"
          value={softness > 0 ? "softness" : "raw"}
          disabled={!page.ready.value}
          onChange={({ currentTarget }) =>
            void commitSettings(page, currentTarget.value === "raw" ? RAW_WEIGHTS : SOFT_LIMITS)
          }
        >
          <option value="softness">Reach and softness</option>
          <option value="raw">Raw weights</option>
        </select>
      </label>
      <Weight label="Locality" weight="locality" ends={["more points follow", "fewer follow"]} />
      <Weight label="Smoothness" weight="smoothness" ends={["sharp, close by", "gentle, wider"]} />
      <p class="quiet small">
        {softness > 0
          ? "Softness stands for both weights."
          : "As on the command line: no reach, and the boundary moves, unless set above."}
      </p>
    </>
  );
}
