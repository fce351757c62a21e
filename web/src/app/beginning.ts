// SPDX-License-Identifier: MIT
import { keepElsewhere, restoreSaved, startAutosave } from "../state/autosave.ts";
import { placeCamera } from "../state/camera.ts";
import { solverIsThere } from "../state/connection.ts";
import { loadFigures, rememberOrigin } from "../state/figures.ts";
import { begin as beginHistory } from "../state/history.ts";
import { openFirst } from "../state/opening.ts";
import { show } from "../state/showing.ts";
import { history, notice, problem, ready, snapshots, unit } from "../state/store.ts";
import { inTurn } from "../state/turns.ts";
import { followAddress, openAddressOverKept } from "./address.ts";
import { keepOffline } from "./offline.ts";

/** Brings back what this tab had; false if there is nothing. */
async function openSaved(saved: ReturnType<typeof restoreSaved>): Promise<boolean> {
  const restored = await saved;
  if (restored.kind === "damaged") {
    problem.value = "The design kept from your last visit is damaged and could not be opened.";
    return false;
  }
  if (restored.kind === "none") return false;
  const { record } = restored;
  let shown = false;
  await inTurn(async () => {
    shown = await show(record.present);
  });
  if (!shown) {
    problem.value = `Your last design could not be opened; it stays kept. ${problem.value ?? ""}`;
    await keepElsewhere();
    return false;
  }
  snapshots.value = record.snapshots;
  history.value = beginHistory(record.present);
  unit.value = record.unit;
  placeCamera(record.camera);
  if (record.figure !== null) rememberOrigin("name", record.figure);
  const time = new Date(record.time).toLocaleString(undefined, {
    dateStyle: "medium",
    timeStyle: "short",
  });
  notice.value = `Your design of ${time} is back.`;
  return true;
}

async function openDesigns(saved: ReturnType<typeof restoreSaved>): Promise<void> {
  const restored = await openSaved(saved);
  if ((await openAddressOverKept()) || restored) return;
  const said = problem.value;
  await openFirst();
  problem.value = said;
}

/** What happens when the page opens: a shared design, the last one, or the first sample; within
 * another page, what that one asks for. */
export async function begin(): Promise<void> {
  const asked = new URLSearchParams(location.search);
  if (asked.has("embed") && window.parent !== window)
    return (await import("../embed/embedded.ts")).beginEmbedded(asked);
  const saved = restoreSaved();
  if (!(await solverIsThere())) return;
  await openDesigns(saved);
  ready.value = true;
  startAutosave();
  followAddress();
  void loadFigures();
  void keepOffline();
}
