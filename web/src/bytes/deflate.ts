// SPDX-License-Identifier: MIT
/**
 * Rejects damaged bytes, and those that unpack to more than `largest` bytes.
 * @param format "deflate" is zlib's, which has a checksum
 */
export async function inflate(
  bytes: Uint8Array | Blob,
  largest: number,
  format: CompressionFormat,
): Promise<Uint8Array> {
  const through = new DecompressionStream(format);
  const stream = new Blob([bytes as BlobPart]).stream().pipeThrough(through);
  const chunks: Uint8Array[] = [];
  let size = 0;
  const reader = stream.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    size += value.length;
    if (size > largest) {
      await reader.cancel().catch(() => {});
      throw new Error("too large");
    }
    chunks.push(value);
  }
  const all = new Uint8Array(size);
  let at = 0;
  for (const chunk of chunks) {
    all.set(chunk, at);
    at += chunk.length;
  }
  return all;
}
