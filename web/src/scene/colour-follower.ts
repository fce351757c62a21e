// SPDX-License-Identifier: MIT
// The panels' colours, or stripes in their place, follow what the state says they show.

import { effect } from "@preact/signals";
import { fetchPart } from "../state/later.ts";
import type { Page } from "../state/page.ts";
import type { ColourBy } from "../state/page-state.ts";
import type { Sight } from "./sight.ts";

/** What the colours show, where it is not how far points moved. */
function figuresOf(page: Page, kind: ColourBy): Float32Array | null {
  if (kind === "health") return page.panelTroubles.value;
  if (kind === "remake") return page.panelHealth.value;
  if (kind === "fairness") return page.bending.value;
  if (kind === "fold") return page.panelFolds.value;
  if (kind === "mobility")
    return page.mobility.value?.of === page.mesh.value ? (page.mobility.value?.ways ?? null) : null;
  if (page.kindDefects.value?.kind === kind) return page.kindDefects.value.values;
  return kind === "planarity" ? page.panelFigures.value : null;
}

async function dress(sight: Sight, striped: boolean): Promise<void> {
  const { page, shell, stage } = sight;
  const part = striped ? await fetchPart(page, () => import("./zebra.ts")) : null;
  if (shell !== sight.shell || striped !== (page.colourBy.peek() === "zebra")) return;
  shell?.wear(part && new part.Zebra());
  stage.invalidate();
}

/** Returns how to stop. */
export function followColours(sight: Sight): () => void {
  const { page, stage } = sight;
  return effect(() => {
    const kind = page.colourBy.value;
    page.displayMesh.value;
    sight.shell?.colourBy(kind, figuresOf(page, kind));
    void dress(sight, kind === "zebra");
    stage.invalidate();
  });
}
