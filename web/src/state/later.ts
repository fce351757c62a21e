// SPDX-License-Identifier: MIT
// Parts of the page that nobody needs to drag a point are fetched when they are first used.
import { done, type Result, refuse } from "../result/result.ts";
import type { Page } from "./page.ts";
import { report } from "./telling.ts";

const NOT_LOADED = refuse("A part of the page could not be loaded. Try again when you are online.");

/** The next call tries again where it cannot be had. */
export const loadPart = <T>(load: () => Promise<T>): Promise<Result<T>> =>
  load().then(done, () => NOT_LOADED);

/** A part that a person asked for; null, with the problem said, if it cannot be had. */
export async function fetchPart<T>(page: Page, load: () => Promise<T>): Promise<T | null> {
  // Whoever asks while it is drawn is not drawn again for this.
  page.fetching.value = page.fetching.peek() + 1;
  const part = await loadPart(load);
  page.fetching.value -= 1;
  if (part.ok) return part.value;
  report(page, part);
  return null;
}
