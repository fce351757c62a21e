// SPDX-License-Identifier: MIT
// A record in the browser's storage, version 2: an object. Version 1 packed all of it into bytes
// (v1/record.ts).

import type { Camera } from "./camera.ts";
import type { Design } from "./design.ts";
import { isRecord } from "./reading.ts";
import {
  fileKey,
  type KeptFiles,
  restoreDesign,
  type StoredDesign,
  storeDesign,
} from "./saved-design.ts";
import type { ReadRecord, SavedRecord, Snapshot } from "./saved-record.ts";

const VERSION = 2;

export interface StoredRecord extends Omit<SavedRecord, "present" | "snapshots"> {
  readonly version: number;
  readonly present: StoredDesign;
  readonly snapshots: readonly (Omit<Snapshot, "design"> & { readonly design: StoredDesign })[];
}

/** The files that designs come from, by their keys. */
export function filesOf(designs: readonly Design[]): Map<string, Blob> {
  const files = new Map<string, Blob>();
  for (const { source } of designs) {
    if (source.kind === "file") files.set(fileKey(source), source.bytes);
  }
  return files;
}

/** A view from nowhere would show nothing. */
const isCamera = ({ position, target }: Camera): boolean =>
  [...position, ...target].every(Number.isFinite);

export const storeRecord = ({ camera, views, ...record }: SavedRecord): StoredRecord => ({
  ...record,
  version: VERSION,
  camera: camera && isCamera(camera) ? camera : null,
  views: views.filter((view) => isCamera(view.camera)),
  present: storeDesign(record.present),
  snapshots: record.snapshots.map((one) => ({ ...one, design: storeDesign(one.design) })),
});

/** null if a file is not there. */
function restore(stored: StoredRecord, files: KeptFiles): SavedRecord | null {
  const { version: _, present: kept, snapshots: all, ...record } = stored;
  const present = restoreDesign(kept, files);
  const snapshots = all.flatMap(({ design: one, ...snapshot }) => {
    const design = restoreDesign(one, files);
    return design ? [{ ...snapshot, design }] : [];
  });
  return present && snapshots.length === all.length ? { ...record, present, snapshots } : null;
}

/** What a slot holds, of whatever version; it never throws. */
export async function readRecord(value: unknown, files: KeptFiles): Promise<ReadRecord> {
  if (value instanceof Uint8Array)
    return (await import("./v1/record.ts")).decodeRecord(value, files);
  const version = isRecord(value) ? Number(value.version) : 0;
  if (version > VERSION) return { kind: "newer" };
  const record = version === VERSION ? restore(value as StoredRecord, files) : null;
  return record ? { kind: "record", record } : { kind: "damaged" };
}
