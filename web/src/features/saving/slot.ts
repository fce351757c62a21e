// SPDX-License-Identifier: MIT
// Each tab keeps its design in a slot of its own. A slot is held by a lock for as long as its tab
// lives, so that two tabs never write the same one. The database is the only thing shared.
import { createStore, delMany, get, keys, setMany } from "idb-keyval";

const TAB_KEY = "planish.slot";
const PREFIX = "slot:";
const RECORD = "record:";

/** What a page of version 1 finds in the slot: "PLNS", version 2. It leaves the slot alone, and so what is
 * in it is never written over by a page that could not read it. */
export const OF_NEWER_PAGE = Uint8Array.of(
  0x50,
  0x4c,
  0x4e,
  0x53,
  2,
  0,
  0,
  0,
  0,
  0,
  0,
  0,
  0,
  0,
  0,
  0,
);

/**
 * Milliseconds a reloaded tab waits for the page before it to let go of its slot. A busy machine may
 * take its time; only the copy of a tab that is still open waits in vain.
 */
const HAND_OVER = 2500;

/** Opened by its first use. */
const STORE = createStore("planish", "designs");

const fileEntry = (slot: string, key: string): string => `file:${slot}:${key}`;

/** sessionStorage may be denied; then every load is a new tab. */
export function rememberSlot(slot: string): void {
  try {
    sessionStorage.setItem(TAB_KEY, slot);
  } catch {
    // Asked again at the next load.
  }
}

function rememberedSlot(): string | null {
  try {
    return sessionStorage.getItem(TAB_KEY);
  } catch {
    return null;
  }
}

const isTimeout = (error: unknown): boolean =>
  error instanceof DOMException && (error.name === "TimeoutError" || error.name === "AbortError");

/** Holds the lock until the page goes; false if another tab has it. */
function hold(slot: string, patience: number): Promise<boolean> {
  return new Promise((resolve, reject) => {
    const held = (lock: Lock | null): Promise<void> | undefined => {
      resolve(lock !== null);
      return lock ? new Promise<void>(() => {}) : undefined;
    };
    const options: LockOptions =
      patience > 0 ? { signal: AbortSignal.timeout(patience) } : { ifAvailable: true };
    navigator.locks.request(`planish-${slot}`, options, held).catch((error: unknown) => {
      if (isTimeout(error)) resolve(false);
      else reject(error);
    });
  });
}

async function slotsInStore(): Promise<string[]> {
  const all = await keys<IDBValidKey>(STORE);
  return all.flatMap((key) =>
    typeof key === "string" && key.startsWith(PREFIX) ? [key.slice(PREFIX.length)] : [],
  );
}

const ofNoOtherTab = (): string => `tab-${Date.now()}-${Math.random()}`;

/** The tab's own slot, else the first of `known` that no other tab has; null if there is none. */
async function claimKnown(known: readonly string[], passed: readonly string[]) {
  const own = rememberedSlot();
  if (own && !passed.includes(own) && (await hold(own, HAND_OVER))) return own;
  for (const slot of known) if (!passed.includes(slot) && (await hold(slot, 0))) return slot;
  return null;
}

/** A slot that nothing is kept in. It is the tab's own from the first rememberSlot() on. */
export async function claimNewSlot(): Promise<string> {
  if (!navigator.locks) return ofNoOtherTab();
  const known = await slotsInStore();
  for (let k = 0; ; ++k) {
    const slot = String(k);
    if (!known.includes(slot) && (await hold(slot, 0))) return slot;
  }
}

/**
 * The slot of this tab, none of `passed`. Without locks (a page that is not served securely) a tab
 * has its own slot until it is closed, and nothing is taken over from another.
 */
export async function claimSlot(passed: readonly string[]): Promise<string> {
  const own = rememberedSlot();
  if (!navigator.locks) return own && !passed.includes(own) ? own : ofNoOtherTab();
  const known = await claimKnown((await slotsInStore()).sort(), passed);
  return known ?? (await claimNewSlot());
}

/** The record of a slot, of whatever version; undefined for none. */
export async function readKept(slot: string): Promise<unknown> {
  return (await get<unknown>(RECORD + slot, STORE)) ?? get<unknown>(PREFIX + slot, STORE);
}

/** What lies beside a record, by key. */
export async function readFiles(slot: string): Promise<Map<string, unknown>> {
  const prefix = fileEntry(slot, "");
  const files = new Map<string, unknown>();
  for (const key of await keys<IDBValidKey>(STORE)) {
    if (typeof key === "string" && key.startsWith(prefix))
      files.set(key.slice(prefix.length), await get<unknown>(key, STORE));
  }
  return files;
}

/** Writes a record and what it names that is not there yet, all or nothing. */
export async function writeRecord(
  slot: string,
  record: object,
  files: ReadonlyMap<string, unknown>,
): Promise<void> {
  const entries = [...files].map(([key, file]): [string, unknown] => [fileEntry(slot, key), file]);
  await setMany([[PREFIX + slot, OF_NEWER_PAGE], [RECORD + slot, record], ...entries], STORE);
}

export const dropFiles = (slot: string, files: readonly string[]): Promise<void> =>
  delMany(
    files.map((key) => fileEntry(slot, key)),
    STORE,
  );
