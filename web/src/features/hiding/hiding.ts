// SPDX-License-Identifier: MIT
// What is selected goes out of the view, or everything else does.

import { row } from "../../mesh/topology.ts";
import { panelAt } from "../../mesh/triangulation.ts";
import { hidden, hiddenPanels } from "../../state/hidden-panels.ts";
import type { Page } from "../../state/page.ts";
import { deselect } from "../../state/selection.ts";

const NONE: ReadonlySet<number> = new Set();

/** The panels at the selected points, or else the selected panel. */
function chosenPanels(page: Page): ReadonlySet<number> {
  const [shown, panel] = [page.displayMesh.value, page.selectedPanel.value];
  if (!shown) return NONE;
  const corners = page.selection.value.flatMap((v) => [...row(shown.topology.corners, v)]);
  if (corners.length > 0) return new Set(corners.map((c) => panelAt(shown.offsets, c)));
  return panel === null ? NONE : new Set([panel]);
}

function hide(page: Page, panels: Iterable<number>): void {
  const of = page.displayMesh.value;
  if (of) hidden(page).value = { of, panels: new Set(panels) };
}

/** What is selected goes out of sight, and is no longer selected. */
export function hideSelected(page: Page): void {
  const chosen = chosenPanels(page);
  if (chosen.size === 0) return;
  hide(page, [...hiddenPanels(page).value, ...chosen]);
  deselect(page);
}

/** Everything but what is selected goes out of sight. */
export function isolateSelected(page: Page): void {
  const [chosen, shown] = [chosenPanels(page), page.displayMesh.value];
  if (chosen.size === 0 || !shown) return;
  const all = Array.from({ length: shown.offsets.length - 1 }, (_, panel) => panel);
  hide(
    page,
    all.filter((panel) => !chosen.has(panel)),
  );
}

export function showAll(page: Page): void {
  hidden(page).value = null;
}
