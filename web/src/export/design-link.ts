// SPDX-License-Identifier: MIT

import type { Camera } from "../design/camera.ts";
import { encodeLink } from "../design/link.ts";
import { recipeOf } from "../design/recipe.ts";
import { done, GIVEN_UP, type Result } from "../result/result.ts";
import { readMark } from "../state/marking.ts";
import type { Page } from "../state/page.ts";
import { companionsOf, type Taken } from "./companions.ts";

/** The link that opens the design and verifies it; within a turn. */
export async function designLink(
  page: Page,
  camera: Camera | null,
  taken: Taken,
): Promise<Result<string>> {
  const design = page.history.value?.present;
  const mark = design ? await readMark(page, design.shape) : GIVEN_UP;
  if (!design || !mark.ok) return mark.ok ? GIVEN_UP : mark;
  const companions = await companionsOf(page, taken);
  const recipe = { ...recipeOf(design, page.unit.value, camera, mark.value), companions };
  const url = new URL(location.href);
  url.hash = "";
  return done(url.href + (await encodeLink(recipe)));
}
