// SPDX-License-Identifier: MIT
import { encodeLink } from "../share/link.ts";
import type { Camera } from "../state/camera.ts";
import { markOf } from "../state/marking.ts";
import { recipeOf } from "../state/recipe.ts";
import { history, unit } from "../state/store.ts";

/** The link that opens the design and verifies it; null without a design. */
export async function designLink(camera: Camera | null): Promise<string | null> {
  const design = history.value?.present;
  const mark = design && (await markOf(design.shape));
  if (!mark) return null;
  const url = new URL(location.href);
  url.hash = "";
  return url.href + (await encodeLink(recipeOf(design, unit.value, camera, mark)));
}
