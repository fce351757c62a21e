// SPDX-License-Identifier: MIT
import { beforeEach, expect, it, vi } from "vitest";
import type { Design } from "../../web/src/design/design.ts";
import { readRecord } from "../../web/src/design/stored-record.ts";
import { restoreSaved, saveNow, startAutosave } from "../../web/src/features/saving/autosave.ts";
import { setTarget, shownPoint, undo } from "../../web/src/state/editing.ts";
import type { Page } from "../../web/src/state/page.ts";
import { takeSnapshot } from "../../web/src/state/snapshots.ts";
import { openedPage, pageAlone } from "./support/page-here.ts";

/** What the database would hold. */
const database = vi.hoisted(() => ({
  record: undefined as unknown,
  files: new Map<string, unknown>(),
  writes: 0,
  full: false,
}));

vi.mock("../../web/src/features/saving/slot.ts", () => ({
  claimSlot: async () => "0",
  claimNewSlot: async () => "1",
  rememberSlot: () => {},
  readKept: async () => database.record,
  readFiles: async () => new Map(database.files),
  dropFiles: async (_slot: string, keys: readonly string[]) => {
    for (const key of keys) database.files.delete(key);
  },
  writeRecord: async (_slot: string, record: object, files: ReadonlyMap<string, unknown>) => {
    if (database.full) throw new DOMException("full", "QuotaExceededError");
    database.writes += 1;
    database.record = structuredClone(record);
    for (const [key, file] of files) database.files.set(key, structuredClone(file));
  },
}));

beforeEach(() => {
  Object.assign(database, { record: undefined, files: new Map(), writes: 0, full: false });
  vi.stubGlobal("document", new EventTarget());
  vi.stubGlobal("window", new EventTarget());
});

const MIDDLE = 220;

it("keeps nothing of a first sample that nobody touched", async () => {
  const page = await openedPage();
  expect(await restoreSaved(page)).toEqual({ kind: "none" });
  const stop = startAutosave(page);
  await saveNow(page);
  stop();
  expect(database.writes).toBe(0);
});

it("keeps the design and its snapshots with every bit, changes close together in one write", async () => {
  const page = await openedPage();
  await restoreSaved(page);
  const stop = startAutosave(page);
  const [x, y, z] = shownPoint(page, MIDDLE);
  await takeSnapshot(page, "flat");
  await setTarget(page, MIDDLE, [x, y, z + 0.2]);
  page.unit.value = "mm";
  page.views.value = [{ name: "Left", camera: { position: [1, 2, 3], target: [0, 0, 0] } }];
  await saveNow(page);
  stop();
  expect(database.writes).toBeLessThanOrEqual(2);
  const read = await readRecord(database.record, new Map());
  if (read.kind !== "record") throw new Error(read.kind);
  expect(read.record.unit).toBe("mm");
  expect(read.record.present.shape).toEqual(page.history.value?.present.shape);
  expect(read.record.views).toEqual(page.views.value);
  expect(read.record.snapshots.map(({ name }) => name)).toEqual(["flat"]);
  const other = pageAlone();
  const restored = await restoreSaved(other);
  expect(restored.kind).toBe("record");
});

/** Five edits, of which two are taken back. */
async function keptSteps(): Promise<Page> {
  const page = await openedPage();
  await restoreSaved(page);
  const stop = startAutosave(page);
  const [x, y, z] = shownPoint(page, MIDDLE);
  for (let k = 1; k <= 5; ++k) {
    await setTarget(page, MIDDLE, [x, y, z + 0.05 * k]);
    await saveNow(page);
  }
  await undo(page);
  await undo(page);
  await saveNow(page);
  stop();
  return page;
}

const shapes = (designs: readonly Design[]) => designs.map(({ shape }) => shape);

it("keeps undo and redo with every bit, each step written once", async () => {
  const page = await keptSteps();
  const history = page.history.value;
  if (!history) throw new Error("no history");
  expect([history.past.length, history.future.length]).toEqual([3, 2]);
  const written = new Map(database.files);
  expect(written.size).toBe(5);
  const other = pageAlone();
  const restored = await restoreSaved(other);
  if (restored.kind !== "record") throw new Error(restored.kind);
  expect(shapes(restored.history.past)).toEqual(shapes(history.past));
  expect(shapes(restored.history.future)).toEqual(shapes(history.future));
  expect(restored.history.present.shape).toEqual(history.present.shape);
  // The next write knows the steps again.
  other.history.value = restored.history;
  const stop = startAutosave(other);
  other.snapshots.value = restored.record.snapshots;
  other.unit.value = "mm";
  other.history.value = { ...restored.history, present: { ...restored.history.present } };
  await saveNow(other);
  stop();
  expect(new Map(database.files)).toEqual(written);
});

it("keeps the steps up to one that is damaged, and the design", async () => {
  const page = await keptSteps();
  const { past = [] } = page.history.value ?? {};
  const second = [...database.files.keys()][1] ?? "";
  database.files.set(second, new Blob(["no step"]));
  const restored = await restoreSaved(pageAlone());
  if (restored.kind !== "record") throw new Error(restored.kind);
  expect(shapes(restored.history.past)).toEqual(shapes(past.slice(2)));
  expect(restored.history.future).toHaveLength(2);
});

it("forgets what is undone and left, with its files", async () => {
  const page = await keptSteps();
  const stop = startAutosave(page);
  const [x, y, z] = shownPoint(page, MIDDLE);
  await setTarget(page, MIDDLE, [x, y, z + 0.4]);
  await saveNow(page);
  stop();
  expect(page.history.value?.future).toEqual([]);
  expect(database.files.size).toBe(4);
});

it("says that it cannot keep the design, and stops saying so once it can", async () => {
  const page = await openedPage();
  await restoreSaved(page);
  const stop = startAutosave(page);
  database.full = true;
  await takeSnapshot(page);
  await saveNow(page);
  expect(page.keeping.value).toMatch(/export or share/);
  database.full = false;
  await takeSnapshot(page);
  await saveNow(page);
  expect(page.keeping.value).toBeNull();
  stop();
});

it("writes as the page is left", async () => {
  const page = await openedPage();
  await restoreSaved(page);
  const stop = startAutosave(page);
  await takeSnapshot(page);
  window.dispatchEvent(new Event("pagehide"));
  await expect.poll(() => database.writes).toBe(1);
  stop();
});

it("what is damaged is said to be, and stays", async () => {
  database.record = new Uint8Array([1, 2, 3]);
  expect((await restoreSaved(pageAlone())).kind).toBe("damaged");
});
