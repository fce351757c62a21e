// SPDX-License-Identifier: MIT
// Panels that are left out of the view: of the picture alone, never of the design or of what is exported.

import { computed, signal } from "@preact/signals";
import type { DisplayMesh } from "../mesh/display-mesh.ts";
import { row } from "../mesh/topology.ts";
import { panelAt } from "../mesh/triangulation.ts";
import { kept, type Page } from "./page.ts";

const NONE: ReadonlySet<number> = new Set();

interface Hidden {
  readonly of: DisplayMesh;
  readonly panels: ReadonlySet<number>;
}

export const hidden = kept(() => signal<Hidden | null>(null));

/** Hidden panels of the mesh that is shown; another mesh is shown whole. */
export const hiddenPanels = kept((page) =>
  computed(() => {
    const { value } = hidden(page);
    return value && value.of === page.displayMesh.value ? value.panels : NONE;
  }),
);

/** Whether all panels at a point are hidden. */
export function isHidden(page: Page, vertex: number): boolean {
  const [panels, shown] = [hiddenPanels(page).value, page.displayMesh.value];
  if (panels.size === 0 || !shown) return false;
  const corners = row(shown.topology.corners, vertex);
  return corners.every((corner) => panels.has(panelAt(shown.offsets, corner)));
}
