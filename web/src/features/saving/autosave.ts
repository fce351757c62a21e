// SPDX-License-Identifier: MIT
// The design and its snapshots are written after every change and come back after a reload or a
// crash. One write is one transaction: what is read is the old record or the new one.

import { effect } from "@preact/signals";
import type { Design } from "../../design/design.ts";
import type { History } from "../../design/history.ts";
import type { KeptFiles, StoredDesign } from "../../design/saved-design.ts";
import type { SavedRecord } from "../../design/saved-record.ts";
import type { StepFiles } from "../../design/saved-steps.ts";
import { readCamera } from "../../state/camera.ts";
import { shownFigure } from "../../state/figures.ts";
import { changedGroups, keptGroups } from "../../state/kept-groups.ts";
import { note } from "../../state/note.ts";
import { kept, type Page } from "../../state/page.ts";
import { sectionPlane } from "../../state/shown-section.ts";
import {
  claimNewSlot,
  claimSlot,
  dropFiles,
  readFiles,
  readKept,
  rememberSlot,
  writeRecord,
} from "./slot.ts";

/** Milliseconds between a change and its write: changes close together are one write. */
const DELAY = 250;
/** Milliseconds after which the page goes on without its storage. */
const PATIENCE = 8000;

/** What reads and writes records: nobody waits for it to move a point. */
const codec = async () => {
  const [record, steps, design] = await Promise.all([
    import("../../design/stored-record.ts"),
    import("../../design/saved-steps.ts"),
    import("../../design/saved-design.ts"),
  ]);
  return { ...record, ...steps, ...design };
};

interface Own {
  slot: string | null;
  /** Keys of the files that lie beside the record. */
  stored: Set<string>;
  steps: StepFiles | null;
  timer: ReturnType<typeof setTimeout> | undefined;
  writing: Promise<void>;
  dirty: boolean;
}

const own = kept(
  (): Own => ({
    slot: null,
    stored: new Set<string>(),
    steps: null,
    timer: undefined,
    writing: Promise.resolve(),
    dirty: false,
  }),
);

const NO_STORAGE =
  "This browser does not let the page keep your design: export or share it before you leave.";

/** What is kept of the page now, and what is new beside it, by key. */
async function whatIsKept(page: Page, history: History<Design>) {
  const keeper = own(page);
  const { filesOf, storeDesign, storeRecord, StepFiles } = await codec();
  keeper.steps ??= new StepFiles();
  const { designs, keys, steps } = keeper.steps.keep(history);
  const { present } = history;
  const snapshots = page.snapshots.value;
  const record: SavedRecord = {
    time: Date.now(),
    unit: page.unit.value,
    camera: readCamera(page),
    figure: shownFigure(page).peek()?.name ?? null,
    present,
    snapshots,
    views: page.views.value,
    note: note(page).value,
    section: sectionPlane(page).value,
    groups: changedGroups(page),
    steps: keys,
  };
  const sources = filesOf([present, ...snapshots.map(({ design }) => design), ...designs]);
  const missing = new Map<string, Blob | StoredDesign>();
  for (const [key, file] of sources) if (!keeper.stored.has(key)) missing.set(key, file);
  for (const [key, step] of steps) if (!keeper.stored.has(key)) missing.set(key, storeDesign(step));
  return {
    record: storeRecord(record),
    missing,
    keys: new Set([...sources.keys(), ...steps.keys()]),
  };
}

async function write(page: Page): Promise<void> {
  const keeper = own(page);
  const { slot } = keeper;
  const history = page.history.value;
  if (slot === null || !history) return;
  try {
    const { record, missing, keys } = await whatIsKept(page, history);
    const unused = [...keeper.stored].filter((key) => !keys.has(key));
    await writeRecord(slot, record, missing);
    rememberSlot(slot);
    keeper.stored = new Set([...keeper.stored, ...keys]);
    page.keeping.value = null;
    if (unused.length > 0) await dropFiles(slot, unused);
    keeper.stored = keys;
  } catch {
    page.keeping.value = NO_STORAGE;
  }
}

/** Writes what has not been written yet; resolves when it is there. */
export function saveNow(page: Page): Promise<void> {
  const keeper = own(page);
  clearTimeout(keeper.timer);
  if (keeper.dirty) {
    keeper.dirty = false;
    keeper.writing = keeper.writing
      .then(() => write(page))
      .then(() => {
        page.unsaved.value = keeper.dirty;
      });
  }
  return keeper.writing;
}

function saveSoon(page: Page): void {
  const keeper = own(page);
  keeper.dirty = true;
  page.unsaved.value = true;
  clearTimeout(keeper.timer);
  keeper.timer = setTimeout(() => void saveNow(page), DELAY);
}

const within = <T>(promise: Promise<T>, milliseconds: number): Promise<T> =>
  Promise.race([
    promise,
    new Promise<never>((_, reject) => setTimeout(() => reject(new Error("slow")), milliseconds)),
  ]);

export type Restored =
  | {
      readonly kind: "record";
      readonly record: SavedRecord;
      readonly history: History<Design>;
    }
  | { readonly kind: "none" }
  | { readonly kind: "damaged" };

interface Loaded {
  readonly slot: string;
  readonly files: KeptFiles;
  readonly steps: StepFiles | null;
  readonly restored: Restored;
}

/** What was kept, with the steps before and after it. */
async function read(value: unknown, files: KeptFiles): Promise<Omit<Loaded, "slot"> | "newer"> {
  const { readRecord, StepFiles } = await codec();
  const found = await readRecord(value, files);
  if (found.kind === "newer") return "newer";
  if (found.kind === "damaged") return { files, steps: null, restored: found };
  const steps = new StepFiles();
  const { present, steps: keys } = found.record;
  const history = await steps.restore(present, keys, files);
  return { files, steps, restored: { ...found, history } };
}

/** A newer version's record is left alone: its slot is passed, nothing is written over it. */
async function load(): Promise<Loaded> {
  for (const passed: string[] = []; ; ) {
    const claimed = await claimSlot(passed);
    const kept = await readKept(claimed);
    if (kept === undefined)
      return { slot: claimed, files: new Map(), steps: null, restored: { kind: "none" } };
    const found = await read(kept, await readFiles(claimed));
    if (found !== "newer") return { slot: claimed, ...found };
    passed.push(claimed);
  }
}

/**
 * Finds this tab's slot and reads it. Never throws, never waits long; what comes too late is left
 * as it is, and nothing is written over it.
 */
export async function restoreSaved(page: Page): Promise<Restored> {
  try {
    const loaded = await within(load(), PATIENCE);
    own(page).slot = loaded.slot;
    own(page).stored = new Set(loaded.files.keys());
    own(page).steps = loaded.steps;
    if (loaded.restored.kind === "record") rememberSlot(loaded.slot);
    return loaded.restored;
  } catch {
    page.keeping.value = NO_STORAGE;
    return { kind: "none" };
  }
}

/** Keeps from now on in another slot: what is in this one could not be opened and stays there. */
export async function keepElsewhere(page: Page): Promise<void> {
  const keeper = own(page);
  keeper.slot = null;
  keeper.stored = new Set();
  keeper.slot = await claimNewSlot().catch(() => null);
}

/** Writes from now on whenever something changes; an untouched first sample is not kept. */
export function startAutosave(page: Page): () => void {
  // Here in time for a page that is closed with the first change.
  codec().catch(() => {});
  const begun = page.history.peek()?.present;
  let worth = false;
  const stop = effect(() => {
    const present = page.history.value?.present;
    page.unit.value;
    sectionPlane(page).value;
    const named = page.snapshots.value.length + page.views.value.length + note(page).value.length;
    const grouped = keptGroups(page).value !== null;
    worth ||= present !== begun || named > 0 || grouped;
    if (worth) saveSoon(page);
  });
  const save = (): void => void saveNow(page);
  const hide = (): void => {
    if (document.visibilityState === "hidden") save();
  };
  document.addEventListener("visibilitychange", hide);
  window.addEventListener("pagehide", save);
  return () => {
    stop();
    document.removeEventListener("visibilitychange", hide);
    window.removeEventListener("pagehide", save);
  };
}
