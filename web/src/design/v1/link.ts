// SPDX-License-Identifier: MIT
// Frozen: a link of version 1, "#v1=" and base64url of these bytes, deflated:
//   CRC-32 of the rest (4 bytes) | length of the JSON (4 bytes) | JSON | the file, if any
// little-endian. In the JSON, beside what steps.ts has: s the source (sample name and size, or file name
// and format), u the unit, c the camera, a what travels beside the design.

import { fromBase64Url } from "../../bytes/base64url.ts";
import { crc32 } from "../../bytes/crc32.ts";
import { inflate } from "../../bytes/deflate.ts";
import { isUnit } from "../../quantity/units.ts";
import type { Result } from "../../result/result.ts";
import type { Source } from "../../solver/protocol.ts";
import { listOf, MOST_VARIANTS, readCompanions, type Variant } from "../companions.ts";
import { isIndex, isName, isRecord, type Json, readCamera, readFormat } from "../reading.ts";
import type { Recipe } from "../recipe.ts";
import { DAMAGED_LINK } from "../refusal.ts";
import { readSteps, readVariant } from "./steps.ts";

export const PREFIX = "#v1=";
const HEADER = 8;

/** Bytes. No browser opens a link as long as one that packs more than this. */
const LARGEST = 32 * 1024 * 1024;

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

/** Of whatever travels beside a design. */
function readVariants(beside: unknown): Variant[] {
  const all = isRecord(beside) ? listOf(beside.s, MOST_VARIANTS) : [];
  return all.flatMap((one) => readVariant(one) ?? []);
}

function readPayload(payload: Json, file: Uint8Array): Recipe | null {
  const source = readSource(payload.s, file);
  const steps = readSteps(payload);
  const camera = readCamera(payload.c);
  const { u: unit } = payload;
  if (!source || !steps || camera === undefined) return null;
  if (typeof unit !== "string" || !isUnit(unit)) return null;
  const companions = readCompanions(payload.a, readVariants(payload.a));
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

/** Any string gives a recipe or a sentence that says what is wrong with it; it never throws. */
export async function decodeLink(hash: string): Promise<Result<Recipe>> {
  const packed = fromBase64Url(hash.slice(PREFIX.length));
  const bytes = packed && (await inflate(packed, LARGEST, "deflate-raw").catch(() => null));
  const recipe = bytes && decodePayload(bytes);
  return recipe ? { ok: true, value: recipe } : DAMAGED_LINK;
}
