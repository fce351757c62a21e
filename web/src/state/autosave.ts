// SPDX-License-Identifier: MIT
// The design and its snapshots are written after every change and come back after a reload or a
// crash. One write is one transaction: what is read is the old record or the new one.
import { effect } from "@preact/signals";
import { type Files, fileKey } from "../share/saved-design.ts";
import { decodeRecord, encodeRecord, type SavedRecord } from "../share/saved-record.ts";
import { readCamera } from "./camera.ts";
import type { Design } from "./design.ts";
import { shownFigure } from "./figures.ts";
import {
  claimNewSlot,
  claimSlot,
  dropFiles,
  readFiles,
  readRecord,
  rememberSlot,
  writeRecord,
} from "./slot.ts";
import { history, keeping, snapshots, unit } from "./store.ts";

/** Milliseconds between a change and its write: changes close together are one write. */
const DELAY = 250;
/** Milliseconds after which the page goes on without its storage. */
const PATIENCE = 8000;

let slot: string | null = null;
/** Keys of the files that lie beside the record. */
let stored = new Set<string>();
let timer: ReturnType<typeof setTimeout> | undefined;
let writing: Promise<void> = Promise.resolve();
let dirty = false;

const NO_STORAGE =
  "This browser does not let the page keep your design: export or share it before you leave.";

/** Undo and redo are not kept; the present and the snapshots are. */
function recordNow(): SavedRecord | null {
  const present = history.value?.present;
  if (!present) return null;
  return {
    time: Date.now(),
    unit: unit.value,
    camera: readCamera(),
    figure: shownFigure.peek()?.name ?? null,
    present,
    snapshots: snapshots.value,
  };
}

function filesOf(record: SavedRecord): Map<string, Blob> {
  const files = new Map<string, Blob>();
  const designs: Design[] = [record.present, ...record.snapshots.map(({ design }) => design)];
  for (const { source } of designs) {
    if (source.kind === "file") files.set(fileKey(source), source.bytes);
  }
  return files;
}

async function write(): Promise<void> {
  const record = recordNow();
  if (slot === null || !record) return;
  const files = filesOf(record);
  const missing = new Map([...files].filter(([key]) => !stored.has(key)));
  const unused = [...stored].filter((key) => !files.has(key));
  try {
    await writeRecord(slot, encodeRecord(record), missing);
    rememberSlot(slot);
    stored = new Set([...stored, ...files.keys()]);
    keeping.value = null;
    if (unused.length > 0) await dropFiles(slot, unused);
    stored = new Set(files.keys());
  } catch {
    keeping.value = NO_STORAGE;
  }
}

/** Writes what has not been written yet; resolves when it is there. */
export function saveNow(): Promise<void> {
  clearTimeout(timer);
  if (dirty) {
    dirty = false;
    writing = writing.then(write);
  }
  return writing;
}

function saveSoon(): void {
  dirty = true;
  clearTimeout(timer);
  timer = setTimeout(() => void saveNow(), DELAY);
}

const within = <T>(promise: Promise<T>, milliseconds: number): Promise<T> =>
  Promise.race([
    promise,
    new Promise<never>((_, reject) => setTimeout(() => reject(new Error("slow")), milliseconds)),
  ]);

export type Restored =
  | { readonly kind: "record"; readonly record: SavedRecord }
  | { readonly kind: "none" }
  | { readonly kind: "damaged" };

interface Loaded {
  readonly slot: string;
  readonly files: Files;
  readonly restored: Restored;
}

/** A newer version's record is left alone: its slot is passed, nothing is written over it. */
async function load(): Promise<Loaded> {
  for (const passed: string[] = []; ; ) {
    const claimed = await claimSlot(passed);
    const bytes = await readRecord(claimed);
    const files: Files = bytes ? await readFiles(claimed) : new Map();
    const read = bytes ? decodeRecord(bytes, files) : ({ kind: "none" } as const);
    if (read.kind !== "newer") return { slot: claimed, files, restored: read };
    passed.push(claimed);
  }
}

/**
 * Finds this tab's slot and reads it. Never throws, never waits long; what comes too late is left
 * as it is, and nothing is written over it.
 */
export async function restoreSaved(): Promise<Restored> {
  try {
    const loaded = await within(load(), PATIENCE);
    slot = loaded.slot;
    stored = new Set(loaded.files.keys());
    if (loaded.restored.kind === "record") rememberSlot(slot);
    return loaded.restored;
  } catch {
    keeping.value = NO_STORAGE;
    return { kind: "none" };
  }
}

/** Keeps from now on in another slot: what is in this one could not be opened and stays there. */
export async function keepElsewhere(): Promise<void> {
  slot = null;
  stored = new Set();
  slot = await claimNewSlot().catch(() => null);
}

/** Writes from now on whenever something changes; an untouched first sample is not kept. */
export function startAutosave(): () => void {
  const begun = history.peek()?.present;
  let worth = snapshots.peek().length > 0;
  const stop = effect(() => {
    const present = history.value?.present;
    const kept = snapshots.value;
    unit.value;
    worth ||= present !== begun || kept.length > 0;
    if (worth) saveSoon();
  });
  const hide = (): void => {
    if (document.visibilityState === "hidden") void saveNow();
  };
  document.addEventListener("visibilitychange", hide);
  window.addEventListener("pagehide", saveNow);
  return () => {
    stop();
    document.removeEventListener("visibilitychange", hide);
    window.removeEventListener("pagehide", saveNow);
  };
}
