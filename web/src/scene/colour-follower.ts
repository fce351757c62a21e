// SPDX-License-Identifier: MIT
// The panels' colours, or what they wear in their place, follow what the state says they show.

import { effect } from "@preact/signals";
import { GROUP_COLOURS } from "../design/groups.ts";
import { groupFigures } from "../state/kept-groups.ts";
import { fetchPart } from "../state/later.ts";
import type { Page } from "../state/page.ts";
import type { ColourBy } from "../state/page-state.ts";
import type { Sight } from "./sight.ts";
import type { Skin } from "./skin.ts";

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

/** What the panels wear in place of their colours. */
const SKINS: Partial<Record<ColourBy, () => Promise<() => Skin>>> = {
  zebra: () =>
    import("../features/analysis/zebra.ts").then(
      ({ Zebra }) =>
        () =>
          new Zebra(),
    ),
  glass: () =>
    import("../features/analysis/glass.ts").then(
      ({ Glass }) =>
        () =>
          new Glass(),
    ),
};

async function dress(sight: Sight, kind: ColourBy): Promise<void> {
  const { page, shell, stage } = sight;
  const skin = SKINS[kind];
  const make = skin ? await fetchPart(page, skin) : null;
  if (shell !== sight.shell || kind !== page.colourBy.peek()) return;
  shell?.wear(make?.() ?? null);
  stage.invalidate();
}

/** Without figures in its colours the picture at rest is shaded by how much sky a place sees. */
async function shade(sight: Sight, kind: ColourBy): Promise<void> {
  const { page, shell, stage } = sight;
  const part =
    kind === "none"
      ? await fetchPart(page, () => import("../features/analysis/occlusion.ts"))
      : null;
  if (shell !== sight.shell || kind !== page.colourBy.peek()) return;
  stage.finishBy(
    part && shell ? new part.Occlusion(shell.panels, stage.ground, stage.camera) : null,
  );
}

/** Returns how to stop. */
export function followColours(sight: Sight): () => void {
  const { page, stage } = sight;
  return effect(() => {
    const kind = page.colourBy.value;
    page.displayMesh.value;
    sight.shell?.colourBy(kind, figuresOf(page, kind));
    void dress(sight, kind);
    void shade(sight, kind);
    stage.invalidate();
  });
}
