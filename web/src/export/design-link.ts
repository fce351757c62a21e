// SPDX-License-Identifier: MIT

import type { Camera } from "../design/camera.ts";
import { encodeLink } from "../design/link.ts";
import { recipeOf } from "../design/recipe.ts";
import { done, GIVEN_UP, type Result } from "../result/result.ts";
import { readMark } from "../state/marking.ts";
import type { Page } from "../state/page.ts";

/** The link that opens the design and verifies it. */
export async function designLink(page: Page, camera: Camera | null): Promise<Result<string>> {
  const design = page.history.value?.present;
  const mark = design ? await readMark(page, design.shape) : GIVEN_UP;
  if (!design || !mark.ok) return mark.ok ? GIVEN_UP : mark;
  const url = new URL(location.href);
  url.hash = "";
  return done(url.href + (await encodeLink(recipeOf(design, page.unit.value, camera, mark.value))));
}
