// SPDX-License-Identifier: MIT
// Parts of the page that nobody needs to drag a point are fetched when they are first used.
import { problem } from "./store.ts";

/** null, with the problem said, if it cannot be had; the next call tries again. */
export async function fetchPart<T>(load: () => Promise<T>): Promise<T | null> {
  try {
    return await load();
  } catch {
    problem.value = "A part of the page could not be loaded. Try again when you are online.";
    return null;
  }
}
