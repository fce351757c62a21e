// SPDX-License-Identifier: MIT
// The panels' colours follow what the state says they show.

import { effect } from "@preact/signals";
import { GROUP_COLOURS } from "../design/groups.ts";
import { groupFigures } from "../state/kept-groups.ts";
import type { Page } from "../state/page.ts";
import type { ColourBy } from "../state/page-state.ts";
import type { Sight } from "./sight.ts";

/** Of each panel the place of its type's colour from 1; 0 without one. */
function typeFigures(page: Page): Float32Array {
  const types = page.shownTypes.value?.types;
  if (!types || types.problem) return new Float32Array();
  return Float32Array.from(types.ofPanel, (type) =>
    type < GROUP_COLOURS.length && (types.sizes[type] ?? 0) > 1 ? type + 1 : 0,
  );
}

/** What the colours show, where it is not how far points moved. */
function figuresOf(page: Page, kind: ColourBy): Float32Array | null {
  if (kind === "health") return page.panelTroubles.value;
  if (kind === "remake") return page.panelHealth.value;
  if (kind === "types") return typeFigures(page);
  if (kind === "groups") return groupFigures(page).value;
  if (kind === "fairness") return page.bending.value;
  if (kind === "fold") return page.panelFolds.value;
  if (kind === "conjugacy")
    return page.conjugacy.value?.of === page.mesh.value
      ? (page.conjugacy.value?.angles ?? null)
      : null;
  if (kind === "mobility")
    return page.mobility.value?.of === page.mesh.value ? (page.mobility.value?.ways ?? null) : null;
  if (page.kindDefects.value?.kind === kind) return page.kindDefects.value.values;
  return kind === "planarity" ? page.panelFigures.value : null;
}

/** Returns how to stop. */
export function followColours(sight: Sight): () => void {
  const { page, stage } = sight;
  return effect(() => {
    const kind = page.colourBy.value;
    page.displayMesh.value;
    sight.shell?.colourBy(kind, figuresOf(page, kind));
    stage.invalidate();
  });
}
