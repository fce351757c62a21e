// SPDX-License-Identifier: MIT
// The zlib format (RFC 1950) with a preset dictionary, which browsers neither write nor read by themselves.
import { zlibSync } from "fflate";
import { inflate } from "./deflate.ts";

/** Bytes of the header with the checksum of a dictionary; of the checksum at the end. */
const HEADER = 6;
const TRAILER = 4;
const HAS_DICTIONARY = 0x20;

/** zlib's checksum. */
function adler32(bytes: Uint8Array): number {
  let [a, b] = [1, 0];
  for (const byte of bytes) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  return b * 65536 + a;
}

export const compress = (bytes: Uint8Array, dictionary: Uint8Array): Uint8Array =>
  zlibSync(bytes, { level: 9, dictionary });

/** `bytes` as a block of raw DEFLATE that is not compressed, and not the last one. */
function stored(bytes: Uint8Array): Blob {
  const { length } = bytes;
  const head = Uint8Array.of(0, length, length >> 8, ~length, ~length >> 8);
  return new Blob([head, bytes as BlobPart]);
}

/** Rejects damaged bytes, and those that unpack to more than `largest` bytes; with another dictionary
 * than `dictionary`, or none, too. */
export async function decompress(
  bytes: Uint8Array,
  dictionary: Uint8Array,
  largest: number,
): Promise<Uint8Array> {
  if (((bytes[1] ?? 0) & HAS_DICTIONARY) === 0) return inflate(bytes, largest, "deflate");
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint16(0) % 31 !== 0) throw new Error("damaged");
  if (view.getUint32(2) !== adler32(dictionary)) throw new Error("another dictionary");
  // To a decompressor the dictionary is what came before.
  const body = bytes.subarray(HEADER, -TRAILER);
  const raw = new Blob([stored(dictionary), body as BlobPart]);
  const all = await inflate(raw, dictionary.length + largest, "deflate-raw");
  const text = all.subarray(dictionary.length);
  if (view.getUint32(bytes.length - TRAILER) !== adler32(text)) throw new Error("damaged");
  return text;
}
