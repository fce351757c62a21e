// SPDX-License-Identifier: MIT
// Designs kept under a name, to come back to or to compare.

import type { Design } from "../design/design.ts";
import * as steps from "../design/history.ts";
import type { Snapshot } from "../design/saved-record.ts";
import { enqueue, type Outcome } from "./action-queue.ts";
import { kept, type Page } from "./page.ts";
import { showStep } from "./showing.ts";

/** A small picture of a design, as a data: address. */
type Draw = (design: Design) => string;

interface Own {
  draw: Draw;
}

const own = kept((): Own => ({ draw: () => "" }));

export function providePictures(page: Page, given: Draw): void {
  own(page).draw = given;
}

/** The first "Snapshot n" that is free. */
function freeName(page: Page): string {
  const taken = new Set(page.snapshots.value.map(({ name }) => name));
  for (let n = 1; ; ++n) if (!taken.has(`Snapshot ${n}`)) return `Snapshot ${n}`;
}

const newId = (): string => `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;

/** A snapshot of a design that is not the one shown: without a picture. */
export const newSnapshot = (name: string, design: Design): Snapshot => ({
  id: newId(),
  name,
  time: Date.now(),
  picture: "",
  design,
});

/** Keeps a design of the mesh that is open, though it is not the one shown. */
export function keepSnapshot(page: Page, design: Design, given?: string, id = newId()): void {
  const name = given ?? freeName(page);
  const snapshot = { id, name, time: Date.now(), picture: own(page).draw(design), design };
  page.snapshots.value = [...page.snapshots.value, snapshot];
  if (given === undefined) page.notice.value = `${name} is kept, under Explore.`;
}

/** Keeps the design once everything that was asked for before is done; gives the snapshot's id. */
export async function takeSnapshot(page: Page, name?: string): Promise<string> {
  const id = newId();
  await enqueue(page, async () => {
    const design = page.history.value?.present;
    if (design) keepSnapshot(page, design, name, id);
  });
  return id;
}

const change = (page: Page, id: string, to: (snapshot: Snapshot) => Snapshot): void => {
  page.snapshots.value = page.snapshots.value.map((snapshot) =>
    snapshot.id === id ? to(snapshot) : snapshot,
  );
};

export function renameSnapshot(page: Page, id: string, name: string): void {
  const trimmed = name.trim().slice(0, 100);
  if (trimmed) change(page, id, (snapshot) => ({ ...snapshot, name: trimmed }));
}

export function deleteSnapshot(page: Page, id: string): void {
  page.snapshots.value = page.snapshots.value.filter((snapshot) => snapshot.id !== id);
}

/** Makes the snapshot the design, as one step of the history. */
export const adoptSnapshot = (page: Page, id: string): Outcome =>
  enqueue(page, async () => {
    const snapshot = page.snapshots.value.find((one) => one.id === id);
    if (!snapshot || !page.history.value || page.history.value.present === snapshot.design) return;
    page.notice.value = null;
    const { design } = snapshot;
    return showStep(page, design, steps.record(page.history.value, design));
  });

/** Whether the design shown is this snapshot. */
export const isShown = (page: Page, snapshot: Snapshot): boolean =>
  page.draft.value === snapshot.design;
