// SPDX-License-Identifier: MIT
/** Four tables of 256: the effect of a byte 0, 1, 2 and 3 places further on. */
const TABLE = new Uint32Array(4 * 256);
for (let n = 0; n < 256; ++n) {
  let c = n;
  for (let k = 0; k < 8; ++k) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  TABLE[n] = c;
}
for (let n = 256; n < 1024; ++n) {
  const c = TABLE[n - 256] ?? 0;
  TABLE[n] = (TABLE[c & 255] ?? 0) ^ (c >>> 8);
}

const at = (bytes: Uint8Array, k: number): number => bytes[k] ?? 0;
const entry = (table: number, c: number): number => TABLE[256 * table + (c & 255)] ?? 0;

/** The CRC-32 of zip and PNG, four bytes at a time. */
export function crc32(bytes: Uint8Array, seed = 0): number {
  let c = ~seed;
  let k = 0;
  for (; k + 3 < bytes.length; k += 4) {
    c ^=
      at(bytes, k) | (at(bytes, k + 1) << 8) | (at(bytes, k + 2) << 16) | (at(bytes, k + 3) << 24);
    c = entry(3, c) ^ entry(2, c >>> 8) ^ entry(1, c >>> 16) ^ entry(0, c >>> 24);
  }
  for (; k < bytes.length; ++k) c = entry(0, c ^ at(bytes, k)) ^ (c >>> 8);
  return ~c >>> 0;
}
