// SPDX-License-Identifier: MIT
// The page's own address: a link stays there until the design is no longer the one it names.
import { effect } from "@preact/signals";
import { isLink } from "../share/fragment.ts";
import type { Design } from "../state/design.ts";
import { rememberOrigin } from "../state/figures.ts";
import { fetchPart } from "../state/later.ts";
import { markOf } from "../state/marking.ts";
import type { Steps } from "../state/recipe.ts";
import { deleteSnapshot, providePictures, takeSnapshot } from "../state/snapshots.ts";
import { history, problem } from "../state/store.ts";

async function replayLink(
  replay: (recipe: Steps) => Promise<boolean>,
  recipe: Steps,
): Promise<boolean> {
  const link = location.hash;
  const opened = await replay(recipe);
  if (opened) rememberOrigin("link", link);
  return opened;
}

/** What opens links; null, with the problem said, if it cannot be loaded. */
const linkParts = () =>
  fetchPart(async () => {
    const [{ readLink }, { replay }] = await Promise.all([
      import("../state/linked.ts"),
      import("../state/replaying.ts"),
    ]);
    return { readLink, replay };
  });

/** Opens the design that the address names; false if there is none or it cannot be opened. */
export async function openAddress(): Promise<boolean> {
  const parts = isLink(location.hash) ? await linkParts() : null;
  if (!parts) return false;
  const recipe = await parts.readLink(location.hash);
  if (recipe.ok) return replayLink(parts.replay, recipe.value);
  problem.value = recipe.reason;
  return false;
}

/** A design that was kept stays as a snapshot, unless it is the link's own. */
async function keepAside(kept: Design, { mark }: Steps): Promise<string | null> {
  if ((await markOf(kept.shape))?.hash === mark?.hash) return null;
  const pictures = await fetchPart(() => import("../ui/snapshot-picture.ts"));
  if (pictures) providePictures(pictures.snapshotPicture);
  return takeSnapshot("Before the link");
}

/** The same over a design that was kept. */
export async function openAddressOverKept(): Promise<boolean> {
  const parts = isLink(location.hash) ? await linkParts() : null;
  const recipe = parts && (await parts.readLink(location.hash));
  const kept = history.value?.present;
  if (!parts || !recipe?.ok || !kept) return openAddress();
  const snapshot = await keepAside(kept, recipe.value);
  const opened = await replayLink(parts.replay, recipe.value);
  if (!opened && snapshot !== null) deleteSnapshot(snapshot);
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
