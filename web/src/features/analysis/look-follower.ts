// SPDX-License-Identifier: MIT
// What panels wear in place of their colours, and how the picture at rest is shaded, follow the choice of colours.
import { effect } from "@preact/signals";
import type { Sight } from "../../scene/sight.ts";
import type { Skin } from "../../scene/skin.ts";
import { fetchPart } from "../../state/later.ts";
import type { ColourBy } from "../../state/page-state.ts";

const SKINS: Partial<Record<ColourBy, () => Promise<new () => Skin>>> = {
  zebra: async () => (await import("./zebra.ts")).Zebra,
  glass: async () => (await import("./glass.ts")).Glass,
};

async function dress(sight: Sight, kind: ColourBy): Promise<void> {
  const { page, shell, stage } = sight;
  const load = SKINS[kind];
  const Own = load ? await fetchPart(page, load) : null;
  if (shell !== sight.shell || kind !== page.colourBy.peek()) return;
  shell?.wear(Own && new Own());
  stage.invalidate();
}

/** Without figures in its colours the picture at rest is shaded by how much sky a place sees. */
async function shade(sight: Sight, kind: ColourBy): Promise<void> {
  const { page, shell, stage } = sight;
  const part = kind === "none" ? await fetchPart(page, () => import("./occlusion.ts")) : null;
  if (shell !== sight.shell || kind !== page.colourBy.peek()) return;
  stage.finishBy(
    part && shell ? new part.Occlusion(shell.panels, stage.ground, stage.camera) : null,
  );
}

/** Returns how to stop. */
export const followLooks = (sight: Sight): (() => void) =>
  effect(() => {
    const kind = sight.page.colourBy.value;
    sight.page.displayMesh.value;
    void dress(sight, kind);
    void shade(sight, kind);
  });
