// SPDX-License-Identifier: MIT
import { DEFAULT_SETTINGS } from "../../../web/src/design/design.ts";
import type { Recipe } from "../../../web/src/design/recipe.ts";

/** A vault that nobody has edited, under the raw weights or other settings. */
export const vault = (size: number, settings = DEFAULT_SETTINGS): Recipe => ({
  source: { kind: "sample", name: "vault", size },
  planarised: null,
  handles: [],
  settings,
  families: [],
  unit: "m",
  camera: null,
  mark: { hash: 0, moved: 0, probes: [] }, // of no shape
});
