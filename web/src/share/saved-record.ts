// SPDX-License-Identifier: MIT
// What autosave keeps of one tab, version 1:
//   "PLNS" | version (4 bytes) | CRC-32 of the rest (4) | length of the JSON (4) | JSON | float64s
// little-endian. Files are kept beside it; the record names them by checksum and size.
import type { Camera } from "../state/camera.ts";
import type { Design } from "../state/design.ts";
import { isUnit, type Unit } from "../state/units.ts";
import { crc32 } from "./crc32.ts";
import { PoolReader, PoolWriter } from "./number-pool.ts";
import {
  isName,
  isNumber,
  isRecord,
  type Json,
  LONGEST_NAME,
  readCamera,
  writeCamera,
} from "./reading.ts";
import { type Files, readDesign, writeDesign } from "./saved-design.ts";

export interface Snapshot {
  readonly id: string;
  readonly name: string;
  /** Milliseconds since 1970. */
  readonly time: number;
  /** A data: address of a small picture; "" for none. */
  readonly picture: string;
  readonly design: Design;
}

export interface SavedRecord {
  /** Milliseconds since 1970. */
  readonly time: number;
  readonly unit: Unit;
  readonly camera: Camera | null;
  /** The paper's figure that the design began as, by its name; null if it is none. */
  readonly figure: string | null;
  readonly present: Design;
  readonly snapshots: readonly Snapshot[];
}

const MAGIC = 0x534e4c50;
const VERSION = 1;
const HEADER = 16;
/** Characters. */
const LONGEST_PICTURE = 200_000;
const PICTURE = /^data:image\/(?:png|webp);base64,[A-Za-z0-9+/=]*$/;

/** What the reader would not take is left out: no picture and no camera may cost the design. */
const readablePicture = (picture: string): string =>
  picture.length <= LONGEST_PICTURE && PICTURE.test(picture) ? picture : "";

const readableCamera = (camera: Camera | null): number[] | null => {
  const numbers = camera ? writeCamera(camera) : [];
  return camera && numbers.every(Number.isFinite) ? numbers : null;
};

export function encodeRecord(record: SavedRecord): Uint8Array {
  const pool = new PoolWriter();
  const json = {
    time: record.time,
    unit: record.unit,
    camera: readableCamera(record.camera),
    figure: record.figure,
    present: writeDesign(record.present, pool),
    snapshots: record.snapshots.map(({ id, name, time, picture, design }) => ({
      id,
      name: name.slice(0, LONGEST_NAME),
      time,
      picture: readablePicture(picture),
      design: writeDesign(design, pool),
    })),
  };
  const text = new TextEncoder().encode(JSON.stringify(json));
  const numbers = pool.bytes();
  const bytes = new Uint8Array(HEADER + text.length + numbers.length);
  bytes.set(text, HEADER);
  bytes.set(numbers, HEADER + text.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, MAGIC, true);
  view.setUint32(4, VERSION, true);
  view.setUint32(12, text.length, true);
  view.setUint32(8, crc32(bytes.subarray(12)), true);
  return bytes;
}

function readSnapshot(value: unknown, pool: PoolReader, files: Files): Snapshot | null {
  if (!isRecord(value)) return null;
  const { id, name, time, picture } = value;
  const design = readDesign(value.design, pool, files);
  if (!isName(id) || !isName(name) || !isNumber(time) || !design) return null;
  if (typeof picture !== "string" || picture.length > LONGEST_PICTURE) return null;
  if (picture !== "" && !PICTURE.test(picture)) return null;
  return { id, name, time, picture, design };
}

function readJson(json: Json, pool: PoolReader, files: Files): SavedRecord | null {
  const { time, unit, snapshots } = json;
  const camera = readCamera(json.camera);
  const figure = isName(json.figure) ? json.figure : null;
  const present = readDesign(json.present, pool, files);
  if (!isNumber(time) || typeof unit !== "string" || !isUnit(unit)) return null;
  if (camera === undefined || !present) return null;
  if (!Array.isArray(snapshots)) return null;
  const read: Snapshot[] = [];
  for (const value of snapshots) {
    const snapshot = readSnapshot(value, pool, files);
    if (!snapshot) return null;
    read.push(snapshot);
  }
  return { time, unit, camera, figure, present, snapshots: read };
}

export type ReadRecord =
  | { readonly kind: "record"; readonly record: SavedRecord }
  | { readonly kind: "newer" }
  | { readonly kind: "damaged" };

const DAMAGED: ReadRecord = { kind: "damaged" };

/** Any bytes give a record or say what they are instead; it never throws. */
export function decodeRecord(bytes: Uint8Array, files: Files): ReadRecord {
  if (bytes.length < HEADER) return DAMAGED;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(0, true) !== MAGIC) return DAMAGED;
  if (view.getUint32(4, true) > VERSION) return { kind: "newer" };
  const end = HEADER + view.getUint32(12, true);
  if (view.getUint32(4, true) !== VERSION || end > bytes.length) return DAMAGED;
  if (view.getUint32(8, true) !== crc32(bytes.subarray(12))) return DAMAGED;
  try {
    const text = new TextDecoder("utf-8", { fatal: true }).decode(bytes.subarray(HEADER, end));
    const json: unknown = JSON.parse(text);
    const pool = new PoolReader(bytes.subarray(end));
    const record = isRecord(json) ? readJson(json, pool, files) : null;
    return record ? { kind: "record", record } : DAMAGED;
  } catch {
    return DAMAGED;
  }
}
