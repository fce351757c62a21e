// SPDX-License-Identifier: MIT
// The structure leaves out the panels that are hidden.

import { effect } from "@preact/signals";
import type { Sight } from "../../scene/sight.ts";
import { hiddenPanels } from "../../state/hidden-panels.ts";
import { fetchPart } from "../../state/later.ts";

/** Returns how to stop. */
export function followHiding(sight: Sight): () => void {
  const { page, stage } = sight;
  const hide = async (): Promise<void> => {
    const { shell } = sight;
    const panels = hiddenPanels(page).value;
    if (!shell) return;
    const whole = panels.size === 0;
    // Panels hide at once, since the page says so and nobody shall hit what is hidden; its edges go a little later.
    shell.hide(panels, whole ? shell.topology : shell.drawn);
    stage.moved();
    const part = whole ? null : await fetchPart(page, () => import("../../mesh/panel-edges.ts"));
    if (!part || shell !== sight.shell || panels !== hiddenPanels(page).peek()) return;
    shell.hide(
      panels,
      part.edgesOfPanels(shell, (panel) => !panels.has(panel)),
    );
    stage.moved();
  };
  return effect(() => void hide());
}
