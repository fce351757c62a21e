// SPDX-License-Identifier: MIT
// What makes a design again: its source and what was done to it, with a mark of the result.

import type { Unit } from "../quantity/units.ts";
import type { ResultMark, Source } from "../solver/protocol.ts";
import type { Camera } from "./camera.ts";
import type { Companions } from "./companions.ts";
import { type Design, type Family, familyOf } from "./design.ts";
import type { MarkedSteps } from "./marked-steps.ts";

export interface Recipe extends MarkedSteps {
  readonly source: Source;
  readonly unit: Unit;
  readonly camera: Camera | null;
  /** What travels beside it; absent for nothing. */
  readonly companions?: Companions | undefined;
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

export const stepsOf = (design: Design, mark: ResultMark): MarkedSteps => ({
  planarised: design.planarised,
  handles: design.handles,
  settings: design.settings,
  families: familiesOf(design),
  mark,
});

export const recipeOf = (
  design: Design,
  unit: Unit,
  camera: Camera | null,
  mark: ResultMark,
): Recipe => ({
  source: design.source,
  ...stepsOf(design, mark),
  unit,
  camera,
});
