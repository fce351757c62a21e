// SPDX-License-Identifier: MIT
// How far an edit reaches: as someone chose, else as far as it has to.
import { type Design, FIRST_SETTINGS } from "../design/design.ts";
import type { EditSettings } from "../solver/protocol.ts";
import { REACHES } from "../solver/reach-steps.ts";
import type { Page } from "./page.ts";

/** Whether a reach may be one that an edit grew to. */
const isGrown = (page: Page, { reach, reachLength }: EditSettings): boolean =>
  !page.reachChosen.value && reachLength === 0 && REACHES.includes(reach);

const isEdited = (page: Page): boolean => (page.history.value?.present.handles.length ?? 0) > 0;

/** Whether the reach of `settings` grows as it is needed. */
export function growsReach(page: Page, settings: EditSettings): boolean {
  const { softness, hardHandles, reach } = settings;
  if (softness === 0 || hardHandles || !isGrown(page, settings)) return false;
  return isEdited(page) || reach === FIRST_SETTINGS.reach;
}

/** Notes before the first edit that a reach is the choice of whoever made the link or the file. */
export function noteReachOfSource(page: Page, { settings }: Design): void {
  if (!isEdited(page) && settings.reach !== FIRST_SETTINGS.reach) page.reachChosen.value = true;
}

/**
 * Those an edit is tried with, the smallest first; none where only that of the settings is. An edit of
 * points that are moved already reaches no less than it does.
 */
export function reachesFor(page: Page, { settings }: Design): readonly number[] {
  if (!growsReach(page, settings)) return [];
  return isEdited(page) ? REACHES.filter((one) => one >= settings.reach) : REACHES;
}

/** Settings for a mesh that nothing moves yet: without the reach that the last edit grew to. */
export const firstReach = (page: Page, settings: EditSettings): EditSettings =>
  isGrown(page, settings) ? { ...settings, reach: FIRST_SETTINGS.reach } : settings;

/** Notes that someone chose it; who goes back from raw weights to what a page starts with did not. */
export function noteReach(
  page: Page,
  { reach, reachLength, softness }: Partial<EditSettings>,
): void {
  if (reach === undefined && reachLength === undefined) return;
  page.reachChosen.value = softness === undefined || reach !== FIRST_SETTINGS.reach;
}
