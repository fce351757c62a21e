// SPDX-License-Identifier: MIT
// The bytes inside a link of version 1:
//   CRC-32 of the rest (4 bytes) | length of the JSON (4 bytes) | JSON | the file, if any
// little-endian. Links are kept readable for ever: what is added may be missing, and a change of
// layout is a new version.

import { crc32 } from "../bytes/crc32.ts";
import { isUnit } from "../quantity/units.ts";
import type { FileFormat, Source } from "../solver/protocol.ts";
import { type CompanionsJson, readCompanions, writeCompanions } from "./companions.ts";
import { readSteps, type StepsJson, writeSteps } from "./payload-steps.ts";
import {
  isIndex,
  isName,
  isRecord,
  type Json,
  readCamera,
  readFormat,
  writeCamera,
} from "./reading.ts";
import type { Recipe } from "./recipe.ts";

const HEADER = 8;

/** The JSON of version 1. Short names: they are part of every link. */
interface Payload extends StepsJson {
  /** Sample name and size, or file name and format. */
  s: [string, number] | [string, FileFormat];
  u: string;
  /** Camera: position and target. */
  c?: number[];
  /** What travels beside the design. */
  a?: CompanionsJson;
}

function toPayload(recipe: Recipe): Payload {
  const { source, camera } = recipe;
  // In the order that links have always had: the same design is the same link.
  const { r, ...steps } = writeSteps(recipe);
  const beside = recipe.companions && writeCompanions(recipe.companions);
  return {
    s: source.kind === "sample" ? [source.name, source.size] : [source.name, source.format],
    ...steps,
    u: recipe.unit,
    ...(camera && { c: writeCamera(camera) }),
    r,
    ...(beside && { a: beside }),
  };
}

export async function encodePayload(recipe: Recipe): Promise<Uint8Array> {
  const { source } = recipe;
  const json = new TextEncoder().encode(JSON.stringify(toPayload(recipe)));
  const file =
    source.kind === "file" ? new Uint8Array(await source.bytes.arrayBuffer()) : new Uint8Array(0);
  const bytes = new Uint8Array(HEADER + json.length + file.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(4, json.length, true);
  bytes.set(json, HEADER);
  bytes.set(file, HEADER + json.length);
  view.setUint32(0, crc32(bytes.subarray(4)), true);
  return bytes;
}

function readSource(value: unknown, file: Uint8Array): Source | null {
  if (!Array.isArray(value) || value.length !== 2) return null;
  const [name, second] = value as [unknown, unknown];
  if (!isName(name)) return null;
  if (isIndex(second)) return { kind: "sample", name, size: second };
  const format = readFormat(second);
  if (!format) return null;
  const bytes = new Blob([file as BlobPart]);
  return { kind: "file", name, format, bytes, crc: crc32(file) };
}

function readPayload(payload: Json, file: Uint8Array): Recipe | null {
  const source = readSource(payload.s, file);
  const steps = readSteps(payload);
  const camera = readCamera(payload.c);
  const { u: unit } = payload;
  if (!source || !steps || camera === undefined) return null;
  if (typeof unit !== "string" || !isUnit(unit)) return null;
  const companions = readCompanions(payload.a);
  return { source, ...steps, unit, camera, ...(companions && { companions }) };
}

/** null if the bytes are not a whole, unchanged recipe. */
export function decodePayload(bytes: Uint8Array): Recipe | null {
  if (bytes.length < HEADER) return null;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const end = HEADER + view.getUint32(4, true);
  if (end > bytes.length || view.getUint32(0, true) !== crc32(bytes.subarray(4))) return null;
  try {
    const text = new TextDecoder("utf-8", { fatal: true }).decode(bytes.subarray(HEADER, end));
    const payload: unknown = JSON.parse(text);
    return isRecord(payload) ? readPayload(payload, bytes.slice(end)) : null;
  } catch {
    return null;
  }
}
