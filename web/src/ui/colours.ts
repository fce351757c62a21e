// SPDX-License-Identifier: MIT
import type { ColourBy } from "../state/page-state.ts";

/** What the colours of the model can mean, as it is offered. */
export const COLOURS: readonly (readonly [ColourBy, string])[] = [
  ["shape", "Shape"],
  ["slide", "Slide"],
  ["displacement", "Displacement"],
  ["planarity", "Planarity"],
  ["fold", "Folds"],
  ["fairness", "Fairness"],
  ["health", "Panel health"],
  ["remake", "Make again"],
  ["types", "Types"],
  ["circular", "Circular"],
  ["conical", "Conical"],
  ["mobility", "Mobility"],
  ["conjugacy", "Conjugate directions"],
  ["zebra", "Reflection lines"],
  ["glass", "Glass"],
  ["groups", "Groups"],
  ["none", "Nothing"],
];
