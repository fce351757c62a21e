// SPDX-License-Identifier: MIT

import { keepElsewhere, restoreSaved, startAutosave } from "../features/saving/autosave.ts";
import { enqueue } from "../state/action-queue.ts";
import { placeCamera } from "../state/camera.ts";
import { solverIsThere } from "../state/connection.ts";
import { loadFigures, rememberOrigin } from "../state/figures.ts";
import { keepTab } from "../state/inspector.ts";
import { keepGroups, keptGroups } from "../state/kept-groups.ts";
import { note } from "../state/note.ts";
import { openFirst } from "../state/opening.ts";
import type { Page } from "../state/page.ts";
import { recoverFromDeath, show } from "../state/showing.ts";
import { sectionPlane } from "../state/shown-section.ts";
import { say } from "../state/telling.ts";
import { followAddress, openAddress, openAddressOverKept } from "./address.ts";
import { keepOffline } from "./offline.ts";

/** Brings back what this tab had; false if there is nothing. */
async function openSaved(page: Page, saved: ReturnType<typeof restoreSaved>): Promise<boolean> {
  const restored = await saved;
  if (restored.kind === "damaged") {
    say(page, "The design kept from your last visit is damaged and could not be opened.");
    return false;
  }
  if (restored.kind === "none") return false;
  const { record } = restored;
  let shown = false;
  await enqueue(page, async () => {
    const end = await show(page, record.present);
    shown = end.ok;
    return end.ok ? undefined : end;
  });
  if (!shown) {
    const why = page.problem.value ?? "";
    say(page, `Your last design could not be opened; it stays kept. ${why}`);
    await keepElsewhere(page);
    return false;
  }
  page.snapshots.value = record.snapshots;
  page.views.value = record.views;
  note(page).value = record.note;
  sectionPlane(page).value = record.section;
  page.history.value = restored.history;
  keptGroups(page).value = null;
  if (record.groups) keepGroups(page, record.groups);
  page.unit.value = record.unit;
  placeCamera(page, record.camera);
  if (record.figure !== null) rememberOrigin(page, "name", record.figure);
  const time = new Date(record.time).toLocaleString(undefined, {
    dateStyle: "medium",
    timeStyle: "short",
  });
  page.notice.value = `Your design of ${time} is back.`;
  return true;
}

async function openDesigns(page: Page, saved: ReturnType<typeof restoreSaved>): Promise<void> {
  const restored = await openSaved(page, saved);
  if ((await openAddressOverKept(page)) || restored) return;
  const said = page.problem.value;
  await openFirst(page);
  say(page, said);
}

/** What happens when the page opens: a shared design, the last one, or the first sample; within
 * another page, what that one asks for. */
export async function begin(page: Page): Promise<void> {
  recoverFromDeath(page);
  const asked = new URLSearchParams(location.search);
  if (asked.has("embed") && window.parent !== window)
    return (await import("../embed/embedded.ts")).beginEmbedded(page, asked, openAddress);
  keepTab(page);
  const saved = restoreSaved(page);
  if (!(await solverIsThere(page))) return;
  await openDesigns(page, saved);
  page.ready.value = true;
  startAutosave(page);
  followAddress(page);
  void loadFigures(page);
  void keepOffline(page);
}
