// SPDX-License-Identifier: MIT
// What makes a design again: its source and what was done to it, with a mark of the result.

import type { Unit } from "../quantity/units.ts";
import type { EditSettings, Planarising, ResultMark, Source } from "../solver/protocol.ts";
import type { Camera } from "./camera.ts";
import { type Design, type Family, familyOf, type HandleRow } from "./design.ts";

export interface Recipe {
  readonly source: Source;
  readonly planarised: Planarising | null;
  readonly handles: readonly HandleRow[];
  readonly settings: EditSettings;
  /** Families of variations, each around what the one before it gave; the last has the sliders. */
  readonly families: readonly Family[];
  readonly unit: Unit;
  readonly camera: Camera | null;
  readonly mark: ResultMark;
}

/** What is done again, whatever came out of it. */
export interface Steps extends Omit<Recipe, "mark"> {
  /** null: nothing was recorded to hold the result against. */
  readonly mark: ResultMark | null;
  /** Checksum of the base that was edited; null where it is not known. */
  readonly baseHash?: number | null;
  /** Sliders that are not named are at 0. */
  readonly someSliders?: boolean;
}

function familiesOf({ variation }: Design): Family[] {
  if (!variation) return [];
  return [...variation.earlier, familyOf(variation)];
}

export const recipeOf = (
  design: Design,
  unit: Unit,
  camera: Camera | null,
  mark: ResultMark,
): Recipe => ({
  source: design.source,
  planarised: design.planarised,
  handles: design.handles,
  settings: design.settings,
  families: familiesOf(design),
  unit,
  camera,
  mark,
});
