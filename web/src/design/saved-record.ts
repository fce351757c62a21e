// SPDX-License-Identifier: MIT
// What autosave keeps of one tab, version 1. Files are kept beside it, and so are the steps of its
// history; the record names them by checksum and size.

import { type PoolReader, PoolWriter } from "../bytes/number-pool.ts";
import { isUnit, type Unit } from "../quantity/units.ts";
import type { Camera, NamedView } from "./camera.ts";
import type { Design } from "./design.ts";
import { type Group, readGroups, writeGroup } from "./groups.ts";
import {
  isName,
  isNumber,
  isRecord,
  type Json,
  LONGEST_NAME,
  readCamera,
  writeCamera,
} from "./reading.ts";
import { packBlock, unpackBlock } from "./saved-block.ts";
import { type Files, fileKey, readDesign, writeDesign } from "./saved-design.ts";
import { isStepKey, NO_STEPS, type StepKeys } from "./saved-steps.ts";
import { readSection, type SectionPlane, writeSection } from "./section-plane.ts";

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
  readonly views: readonly NamedView[];
  /** What its author says of the design; "" for nothing. */
  readonly note: string;
  /** What cuts the view open; null for nothing. */
  readonly section: SectionPlane | null;
  /** Made or changed here, of the present mesh; null for those of its file. */
  readonly groups: readonly Group[] | null;
  /** Undo and redo. */
  readonly steps: StepKeys;
}

const MAGIC = 0x534e4c50; // "PLNS"
const VERSION = 1;
/** Characters; one's own below what came with designs. */
const LONGEST_KEPT_NOTE = 20_000;
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

/** The files that designs come from, by their keys. */
export function filesOf(designs: readonly Design[]): Map<string, Blob> {
  const files = new Map<string, Blob>();
  for (const { source } of designs) {
    if (source.kind === "file") files.set(fileKey(source), source.bytes);
  }
  return files;
}

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
    views: record.views.map(({ name, camera }) => ({
      name: name.slice(0, LONGEST_NAME),
      camera: readableCamera(camera),
    })),
    note: record.note.slice(0, LONGEST_KEPT_NOTE),
    section: record.section && writeSection(record.section),
    groups: record.groups?.map(writeGroup),
    steps: record.steps,
  };
  return packBlock(MAGIC, VERSION, json, pool);
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

/** None in records from before they were kept; no view may cost the design. */
function readViews(value: unknown): NamedView[] {
  const views = new Map<string, NamedView>();
  for (const one of Array.isArray(value) ? value : []) {
    const { name, camera: numbers } = isRecord(one) ? one : {};
    const camera = readCamera(numbers);
    if (isName(name) && camera) views.set(name, { name, camera });
  }
  return [...views.values()];
}

/** None in records from before they were kept. */
function readStepKeys(value: unknown): StepKeys {
  if (!isRecord(value)) return NO_STEPS;
  const keys = (list: unknown): string[] => (Array.isArray(list) ? list.filter(isStepKey) : []);
  return { past: keys(value.past), future: keys(value.future) };
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
  const [views, steps] = [readViews(json.views), readStepKeys(json.steps)];
  // None in records from before it was kept.
  const note = typeof json.note === "string" ? json.note.slice(0, LONGEST_KEPT_NOTE) : "";
  const section = readSection(json.section);
  const groups = Array.isArray(json.groups) ? readGroups(json.groups) : null;
  const beside = { views, note, section, groups, steps };
  return { time, unit, camera, figure, present, snapshots: read, ...beside };
}

export type ReadRecord =
  | { readonly kind: "record"; readonly record: SavedRecord }
  | { readonly kind: "newer" }
  | { readonly kind: "damaged" };

/** Any bytes give a record or say what they are instead; it never throws. */
export function decodeRecord(bytes: Uint8Array, files: Files): ReadRecord {
  const read = unpackBlock(MAGIC, VERSION, bytes, (json, pool) => readJson(json, pool, files));
  return typeof read === "string" ? { kind: read } : { kind: "record", record: read };
}
