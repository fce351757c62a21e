// SPDX-License-Identifier: MIT

import type { Page } from "../../state/page.ts";
import { explore } from "./exploring.ts";
import { fillGallery } from "./gallery.ts";

/** Finds the sliders of the edit, shows where they are, and fills the gallery beside them. */
export async function findVariations(page: Page): Promise<void> {
  page.sheetFolded.value = false;
  await explore(page);
  // The sliders and the gallery are what was asked for; there is room to scroll once they are drawn.
  await new Promise((drawn) => setTimeout(drawn));
  if (page.draft.value?.variation)
    document.getElementById("step-explore")?.parentElement?.scrollIntoView();
  await fillGallery(page);
}
