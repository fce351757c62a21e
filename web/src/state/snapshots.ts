// SPDX-License-Identifier: MIT
// Designs kept under a name, to come back to or to compare.
import type { Snapshot } from "../share/saved-record.ts";
import * as steps from "./history.ts";
import { show, showPresent } from "./showing.ts";
import { draft, history, notice, snapshots } from "./store.ts";
import { inTurn } from "./turns.ts";

/** A small picture of the design shown, as a data: address. */
type Draw = () => string;
let draw: Draw = () => "";

export function providePictures(given: Draw): void {
  draw = given;
}

/** The first "Snapshot n" that is free. */
function freeName(): string {
  const taken = new Set(snapshots.value.map(({ name }) => name));
  for (let n = 1; ; ++n) if (!taken.has(`Snapshot ${n}`)) return `Snapshot ${n}`;
}

const newId = (): string => `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;

/** Keeps the design once everything that was asked for before is done; gives the snapshot's id. */
export async function takeSnapshot(name?: string): Promise<string> {
  const id = newId();
  await inTurn(async () => {
    const design = history.value?.present;
    if (!design) return;
    const called = name ?? freeName();
    const snapshot = { id, name: called, time: Date.now(), picture: draw(), design };
    snapshots.value = [...snapshots.value, snapshot];
  });
  return id;
}

const change = (id: string, to: (snapshot: Snapshot) => Snapshot): void => {
  snapshots.value = snapshots.value.map((snapshot) =>
    snapshot.id === id ? to(snapshot) : snapshot,
  );
};

export function renameSnapshot(id: string, name: string): void {
  const trimmed = name.trim().slice(0, 100);
  if (trimmed) change(id, (snapshot) => ({ ...snapshot, name: trimmed }));
}

export function deleteSnapshot(id: string): void {
  snapshots.value = snapshots.value.filter((snapshot) => snapshot.id !== id);
}

/** Makes the snapshot the design, as one step of the history. */
export const adoptSnapshot = (id: string): Promise<void> =>
  inTurn(async () => {
    const snapshot = snapshots.value.find((one) => one.id === id);
    if (!snapshot || !history.value || history.value.present === snapshot.design) return;
    notice.value = null;
    if (await show(snapshot.design)) history.value = steps.record(history.value, snapshot.design);
    else await showPresent();
  });

/** Whether the design shown is this snapshot. */
export const isShown = (snapshot: Snapshot): boolean => draft.value === snapshot.design;
