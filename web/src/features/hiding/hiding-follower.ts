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
    const whole = panels.size === 0;
    const part = whole ? null : await fetchPart(page, () => import("../../mesh/panel-edges.ts"));
    if (!shell || shell !== sight.shell || panels !== hiddenPanels(page).peek()) return;
    if (whole) shell.hide(panels, shell.topology);
    else if (part)
      shell.hide(
        panels,
        part.edgesOfPanels(shell, (panel) => !panels.has(panel)),
      );
    stage.moved();
  };
  return effect(() => void hide());
}
