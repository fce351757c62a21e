// SPDX-License-Identifier: MIT
// The design's second layer, which nothing picks or drags, follows the state.

import { effect } from "@preact/signals";
import type { Palette } from "../../scene/palette.ts";
import type { Sight } from "../../scene/sight.ts";
import { hiddenPanels } from "../../state/hidden-panels.ts";
import { fetchPart } from "../../state/later.ts";

/** Returns how to stop. */
export function followOffset(sight: Sight, palette: () => Palette): () => void {
  const { page, stage } = sight;
  let shown: { dispose(): void } | null = null;
  const lay = async (): Promise<void> => {
    const [shell, layer] = [sight.shell, page.offsetLayer.value];
    // The layer leaves out the panels that the structure does.
    hiddenPanels(page).value;
    if (!shell || (!layer && !shown)) return;
    const part = await fetchPart(page, () => import("./offset-layer.ts"));
    if (shell !== sight.shell || layer !== page.offsetLayer.peek()) return;
    shown?.dispose();
    shown = (layer && part?.layOffset(page, shell, layer, palette())) ?? null;
    stage.invalidate();
  };
  return effect(() => void lay());
}
