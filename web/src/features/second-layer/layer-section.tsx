// SPDX-License-Identifier: MIT
// Where a second layer is asked for: beside the model, which stays in sight. What asks comes when it unfolds.
import { useSignal, useSignalEffect } from "@preact/signals";
import type { ComponentType } from "preact";
import { layerAsked } from "../../state/inspector.ts";
import { fetchPart } from "../../state/later.ts";
import { usePage } from "../../ui/page-context.ts";

export function LayerSection() {
  const page = usePage();
  const asked = layerAsked(page);
  const part = useSignal<{ readonly SecondLayer: ComponentType } | null>(null);
  useSignalEffect(() => {
    if (!asked.value || part.peek()) return;
    void fetchPart(page, () => import("./second-layer.tsx")).then((found) => {
      part.value = found;
    });
  });
  const SecondLayer = part.value?.SecondLayer;
  return (
    <details
      class="step folded"
      open={asked.value}
      onToggle={({ currentTarget }) => {
        asked.value = currentTarget.open;
      }}
    >
      <summary>Second layer</summary>
      {asked.value && SecondLayer && <SecondLayer />}
    </details>
  );
}
