// SPDX-License-Identifier: MIT
import { decodeLink, isLink } from "../share/link.ts";
import { client } from "../state/connection.ts";
import { openFirst } from "../state/opening.ts";
import { replay } from "../state/replaying.ts";
import { problem, ready, stranded } from "../state/store.ts";
import { keepOffline } from "./offline.ts";

/** Opens the design of the page's own address; false if there is none to open. */
async function openAddress(): Promise<boolean> {
  if (!isLink(location.hash)) return false;
  const recipe = await decodeLink(location.hash);
  if (recipe.ok) return replay(recipe.value);
  problem.value = recipe.reason;
  return false;
}

/** What happens when the page opens: a shared design, or the first sample. */
export async function begin(): Promise<void> {
  try {
    await client.ready;
  } catch (error) {
    problem.value = error instanceof Error ? error.message : String(error);
    stranded.value = true;
    return;
  }
  if (!(await openAddress())) {
    const said = problem.value;
    await openFirst();
    problem.value = said;
  }
  ready.value = true;
  void keepOffline();
  window.addEventListener("hashchange", () => void openAddress());
}
