// SPDX-License-Identifier: MIT
// The page's own address: a link stays there until the design is no longer the one it names.

import { effect } from "@preact/signals";
import type { Design } from "../design/design.ts";
import { isLink } from "../design/fragment.ts";
import type { Steps } from "../design/recipe.ts";
import { rememberOrigin } from "../state/figures.ts";
import { fetchPart } from "../state/later.ts";
import { markOf } from "../state/marking.ts";
import type { Page } from "../state/page.ts";
import { deleteSnapshot, providePictures, takeSnapshot } from "../state/snapshots.ts";
import { say } from "../state/telling.ts";

async function replayLink(
  page: Page,
  replay: (page: Page, recipe: Steps) => Promise<boolean>,
  recipe: Steps,
): Promise<boolean> {
  const link = location.hash;
  const opened = await replay(page, recipe);
  if (opened) rememberOrigin(page, "link", link);
  return opened;
}

/** What opens links; null, with the problem said, if it cannot be loaded. */
const linkParts = (page: Page) =>
  fetchPart(page, async () => {
    const [{ readLink }, { replay }] = await Promise.all([
      import("../features/sharing/linked.ts"),
      import("../state/replaying.ts"),
    ]);
    return { readLink, replay };
  });

/** Opens the design that the address names; false if there is none or it cannot be opened. */
export async function openAddress(page: Page): Promise<boolean> {
  const parts = isLink(location.hash) ? await linkParts(page) : null;
  if (!parts) return false;
  const recipe = await parts.readLink(page, location.hash);
  if (recipe.ok) return replayLink(page, parts.replay, recipe.value);
  say(page, recipe.reason);
  return false;
}

/** A design that was kept stays as a snapshot, unless it is the link's own. */
async function keepAside(page: Page, kept: Design, { mark }: Steps): Promise<string | null> {
  if ((await markOf(page, kept.shape))?.hash === mark?.hash) return null;
  const pictures = await fetchPart(page, () => import("../features/comparing/snapshot-picture.ts"));
  if (pictures) providePictures(page, (design) => pictures.snapshotPicture(page, design));
  return takeSnapshot(page, "Before the link");
}

/** Opens what the address names over a design that was kept. */
export async function openAddressOverKept(page: Page): Promise<boolean> {
  const parts = isLink(location.hash) ? await linkParts(page) : null;
  const recipe = parts && (await parts.readLink(page, location.hash));
  const kept = page.history.value?.present;
  if (!parts || !recipe?.ok || !kept) return openAddress(page);
  const snapshot = await keepAside(page, kept, recipe.value);
  const opened = await replayLink(page, parts.replay, recipe.value);
  if (!opened && snapshot !== null) deleteSnapshot(page, snapshot);
  return opened;
}

/** A reload shall bring back what was made of a link, not the link. */
function dropStaleLink(page: Page): () => void {
  let named = page.history.peek()?.present;
  let hash = location.hash;
  return effect(() => {
    const present = page.history.value?.present;
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
export function followAddress(page: Page): void {
  dropStaleLink(page);
  window.addEventListener("hashchange", () => void openAddress(page));
}
