// SPDX-License-Identifier: MIT
// What travels beside the design that is shown: what was written and kept under names here.
import { type Companions, MOST_VARIANTS, type Variant } from "../design/companions.ts";
import { stepsOf } from "../design/recipe.ts";
import { groups } from "../state/groups.ts";
import { isSameSource } from "../state/kept-groups.ts";
import { readMark } from "../state/marking.ts";
import { note } from "../state/note.ts";
import type { Page } from "../state/page.ts";
import { sectionPlane } from "../state/shown-section.ts";

/** Which of it goes along. */
export interface Taken {
  readonly note: boolean;
  readonly views: boolean;
  readonly snapshots: boolean;
  readonly groups: boolean;
}

export const EVERYTHING: Taken = { note: true, views: true, snapshots: true, groups: true };
export const NOTHING: Taken = { note: false, views: false, snapshots: false, groups: false };

/** Snapshots of the mesh that is shown, the latest if there are too many: those of others would need
 * their meshes too. */
export function snapshotsToSend(page: Page) {
  const source = page.history.value?.present.source;
  return page.snapshots.value
    .filter(({ design }) => source && isSameSource(design.source, source))
    .slice(-MOST_VARIANTS);
}

/** What travels beside the design; within a queued action. A snapshot whose mark cannot be read stays here. */
export async function companionsOf(page: Page, taken: Taken): Promise<Companions> {
  const variants: Variant[] = [];
  for (const { name, design } of taken.snapshots ? snapshotsToSend(page) : []) {
    const mark = await readMark(page, design.shape);
    if (mark.ok) variants.push({ name, steps: stepsOf(design, mark.value) });
  }
  return {
    note: taken.note ? note(page).value.trim() : "",
    views: taken.views ? page.views.value : [],
    variants,
    section: taken.views ? sectionPlane(page).value : null,
    groups: taken.groups ? groups(page).value : [],
  };
}
