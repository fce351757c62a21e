// SPDX-License-Identifier: MIT
// The structure on the stage: made for the mesh that is shown, and moved as its points move.

import { effect, untracked } from "@preact/signals";
import type { DisplayMesh } from "../mesh/display-mesh.ts";
import { onChanges } from "../state/connection.ts";
import type { Palette } from "./palette.ts";
import { Shell } from "./shell.ts";
import type { Sight } from "./sight.ts";

/** Milliseconds after which a large mesh gets its shadow. */
const SHADOW_DELAY = 1000;

export interface StructureEvents {
  /** A new one takes its place on the stage. */
  readonly making: () => void;
  /** A mesh stands in the view; `kept`: it is much the same as the one before. */
  readonly made: (shown: DisplayMesh, kept: boolean) => void;
  readonly moved: () => void;
}

function castLater(sight: Sight, shell: Shell): void {
  setTimeout(() => {
    if (shell !== sight.shell) return;
    shell.castShadow();
    sight.stage.castShadows();
  }, SHADOW_DELAY);
}

/** Returns how to stop. */
export function followStructure(
  sight: Sight,
  palette: () => Palette,
  { making, made, moved }: StructureEvents,
): () => void {
  const { page, stage } = sight;
  const off = onChanges(page, (changes) => {
    sight.shell?.apply(changes);
    moved();
  });
  const make = (shown: DisplayMesh): void => {
    const kept = sight.shell?.showsMuchTheSame(shown) ?? false;
    sight.shell?.dispose();
    const shell = new Shell(shown, palette());
    sight.shell = shell;
    making();
    stage.setSubject(shell.group, shell.bounds());
    made(shown, kept);
    if (shell.shadowToCome) castLater(sight, shell);
  };
  const stop = effect(() => {
    const shown = page.displayMesh.value;
    // The first drawing, within, reads much of the state that this does not follow.
    if (shown) untracked(() => make(shown));
  });
  return () => {
    off();
    stop();
  };
}
