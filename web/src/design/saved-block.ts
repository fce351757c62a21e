// SPDX-License-Identifier: MIT
// How autosave lays out what it keeps:
//   magic (4 bytes) | version (4) | CRC-32 of the rest (4) | length of the JSON (4) | JSON | float64s
// little-endian.

import { crc32 } from "../bytes/crc32.ts";
import { PoolReader, type PoolWriter } from "../bytes/number-pool.ts";
import { isRecord, type Json } from "./reading.ts";

const HEADER = 16;

export function packBlock(
  magic: number,
  version: number,
  json: unknown,
  pool: PoolWriter,
): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const numbers = pool.bytes();
  const bytes = new Uint8Array(HEADER + text.length + numbers.length);
  bytes.set(text, HEADER);
  bytes.set(numbers, HEADER + text.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, magic, true);
  view.setUint32(4, version, true);
  view.setUint32(12, text.length, true);
  view.setUint32(8, crc32(bytes.subarray(12)), true);
  return bytes;
}

/** Any bytes give what `read` makes of them, or say what they are instead; it never throws. */
export function unpackBlock<T>(
  magic: number,
  version: number,
  bytes: Uint8Array,
  read: (json: Json, pool: PoolReader) => T | null,
): T | "newer" | "damaged" {
  if (bytes.length < HEADER) return "damaged";
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(0, true) !== magic) return "damaged";
  if (view.getUint32(4, true) > version) return "newer";
  const end = HEADER + view.getUint32(12, true);
  if (view.getUint32(4, true) !== version || end > bytes.length) return "damaged";
  if (view.getUint32(8, true) !== crc32(bytes.subarray(12))) return "damaged";
  try {
    const text = new TextDecoder("utf-8", { fatal: true }).decode(bytes.subarray(HEADER, end));
    const json: unknown = JSON.parse(text);
    return (isRecord(json) ? read(json, new PoolReader(bytes.subarray(end))) : null) ?? "damaged";
  } catch {
    return "damaged";
  }
}
