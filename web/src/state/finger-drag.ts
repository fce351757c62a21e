// SPDX-License-Identifier: MIT
// A finger hides what it does: once it is lifted, its drag can be discarded where it was made, for as
// long as that was the last step.
import { effect, signal } from "@preact/signals";
import type { Design } from "../design/design.ts";
import type { Outcome } from "./action-queue.ts";
import { undo } from "./editing.ts";
import { kept, type Page } from "./page.ts";

export interface FingerDrag {
  /** The point that led. */
  readonly vertex: number;
  /** What it gave. */
  readonly design: Design;
}

/** The one that can be kept or discarded; another drag, or any other step, ends that. */
export const fingerDrag = kept((page) => {
  const drag = signal<FingerDrag | null>(null);
  effect(() => {
    const design = page.draft.value;
    if (drag.value && drag.value.design !== design) drag.value = null;
  });
  return drag;
});

/** Where its buttons are, pixels of the view; null before that is known. */
export const offerPlace = kept(() =>
  signal<{ readonly x: number; readonly y: number } | null>(null),
);

/** Waits for what comes of a drag; nothing is offered for one that changed nothing. */
export async function offerToTakeBack(page: Page, vertex: number, ended: Outcome): Promise<void> {
  const made = await ended;
  const design = page.history.value?.present;
  if (made?.ok && design && made.value === design) fingerDrag(page).value = { vertex, design };
}

export function keepDrag(page: Page): void {
  fingerDrag(page).value = null;
}

export async function discardDrag(page: Page): Outcome {
  const drag = fingerDrag(page).value;
  keepDrag(page);
  const last = drag?.design === page.history.value?.present && page.queued.value === 0;
  return drag && last ? undo(page) : undefined;
}
