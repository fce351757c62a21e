// SPDX-License-Identifier: MIT
// The page's own address: a link stays there until the design is no longer the one it names.
import { effect } from "@preact/signals";
import { decodeLink, isLink } from "../share/link.ts";
import { markOf } from "../state/recipe.ts";
import { replay } from "../state/replaying.ts";
import { deleteSnapshot, takeSnapshot } from "../state/snapshots.ts";
import { history, problem } from "../state/store.ts";

/** Opens the design that the address names; false if there is none or it cannot be opened. */
export async function openAddress(): Promise<boolean> {
  if (!isLink(location.hash)) return false;
  const recipe = await decodeLink(location.hash);
  if (recipe.ok) return replay(recipe.value);
  problem.value = recipe.reason;
  return false;
}

/** The same over a design that was kept, which stays as a snapshot. */
export async function openAddressOverKept(): Promise<boolean> {
  const recipe = isLink(location.hash) ? await decodeLink(location.hash) : null;
  const kept = history.value?.present;
  if (!recipe?.ok || !kept) return openAddress();
  if (markOf(kept.shape).hash === recipe.value.mark.hash) return replay(recipe.value);
  const snapshot = takeSnapshot("Before the link");
  const opened = await replay(recipe.value);
  if (!opened) deleteSnapshot(snapshot);
  return opened;
}

/** A reload shall bring back what was made of a link, not the link. */
function dropStaleLink(): () => void {
  let named = history.peek()?.present;
  let hash = location.hash;
  return effect(() => {
    const present = history.value?.present;
    if (location.hash !== hash) {
      hash = location.hash;
      named = present;
    }
    if (present === named || !isLink(location.hash)) return;
    window.history.replaceState(null, "", location.pathname + location.search);
    hash = "";
  });
}

/** Follows the address from now on: a link typed or pasted there is opened. */
export function followAddress(): void {
  dropStaleLink();
  window.addEventListener("hashchange", () => void openAddress());
}
