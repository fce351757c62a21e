// SPDX-License-Identifier: MIT
// The weights of (7) that the next variations are found by, for those who know what they ask for.

import { variationWeights as USUAL } from "virtual:core-defaults";
import type { VariationWeights as Weights } from "../../solver/protocol.ts";
import type { Page } from "../../state/page.ts";
import { usePage } from "../../ui/page-context.ts";
import { Slider } from "../../ui/slider.tsx";

interface Row {
  readonly weight: keyof Weights;
  readonly label: string;
  readonly range: readonly [min: number, max: number, step: number];
  readonly ends: readonly [string, string];
}

const ROWS: readonly Row[] = [
  {
    weight: "fairness",
    label: "Variations bend softly",
    range: [0, 20, 0.5],
    ends: ["sharp, close by", "gentle, wider"],
  },
  {
    weight: "sparsity",
    label: "Variations stay small",
    range: [0.1, 10, 0.1],
    ends: ["more points each", "fewer points each"],
  },
  {
    weight: "closeness",
    label: "Handles stay put",
    range: [0, 100, 1],
    ends: ["handles move along", "handles stay"],
  },
  {
    weight: "correlation",
    label: "Variations stay about the edit",
    range: [0, 0.95, 0.05],
    ends: ["elsewhere, too", "about the edit"],
  },
  {
    weight: "spread",
    label: "Rings around the edit",
    range: [0, 10, 1],
    ends: ["the edit alone", "far around it"],
  },
];

const FAMILY: Row = {
  weight: "family",
  label: "Smoothest of",
  range: [0, 24, 1],
  ends: ["those asked for", "24 directions"],
};

function choose(page: Page, weight: keyof Weights, value: number): void {
  const next = { ...(page.variationWeights.value ?? USUAL), [weight]: value };
  const usual = Object.entries(USUAL).every(([name, x]) => next[name as keyof Weights] === x);
  page.variationWeights.value = usual ? undefined : next;
}

function WeightSlider({ weight, label, range, ends }: Row) {
  const page = usePage();
  const [min, max, step] = range;
  const value = (page.variationWeights.value ?? USUAL)[weight];
  return (
    <Slider
      label={label}
      value={value}
      min={min}
      max={max}
      step={step}
      shown={String(Math.round(100 * value) / 100)}
      ends={ends}
      disabled={!page.ready.value}
      onInput={(x) => choose(page, weight, x)}
      onCommit={(x) => choose(page, weight, x)}
    />
  );
}

export function VariationWeights() {
  const page = usePage();
  return (
    <details class="disclosure">
      <summary>Weights of variations</summary>
      <p class="quiet small">
        They hold from the next “Find variations” on, in designs and links too.
      </p>
      {ROWS.map((row) => (
        <WeightSlider key={row.weight} {...row} />
      ))}
      {page.eigenbasis.value && <WeightSlider {...FAMILY} />}
      {page.variationWeights.value && (
        <button
          type="button"
          class="button small"
          onClick={() => {
            page.variationWeights.value = undefined;
          }}
        >
          Default weights
        </button>
      )}
    </details>
  );
}
