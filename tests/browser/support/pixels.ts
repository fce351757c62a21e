// SPDX-License-Identifier: MIT
// The colours of a screenshot.
import { inflateSync } from "node:zlib";
import { expect } from "vitest";

export interface Picture {
  readonly width: number;
  readonly height: number;
  /** Red, green and blue, 0 … 255. */
  at(x: number, y: number): readonly [number, number, number];
}

function paeth(left: number, above: number, corner: number): number {
  const guess = left + above - corner;
  const [a, b, c] = [Math.abs(guess - left), Math.abs(guess - above), Math.abs(guess - corner)];
  if (a <= b && a <= c) return left;
  return b <= c ? above : corner;
}

/** What each of PNG's filters adds to a byte. */
const FILTERS: readonly ((left: number, above: number, corner: number) => number)[] = [
  () => 0,
  (left) => left,
  (_, above) => above,
  (left, above) => (left + above) >> 1,
  paeth,
];

/** The chunks of compressed pixels, put together. */
function pixelData(png: Buffer): Buffer {
  const parts: Buffer[] = [];
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at)) {
    const end = at + 8 + png.readUInt32BE(at);
    if (png.toString("latin1", at + 4, at + 8) === "IDAT") parts.push(png.subarray(at + 8, end));
  }
  return inflateSync(Buffer.concat(parts));
}

/** Reads the PNGs that the browser makes: 8 bits, with or without alpha, not interlaced. */
export function readPng(png: Buffer): Picture {
  const [width, height] = [png.readUInt32BE(16), png.readUInt32BE(20)];
  const channels = png[25] === 6 ? 4 : 3;
  const stride = width * channels;
  const coded = pixelData(png);
  const bytes = new Uint8Array(stride * height);
  const byte = (row: number, k: number): number =>
    row < 0 || k < 0 ? 0 : (bytes[row * stride + k] ?? 0);
  for (let y = 0; y < height; ++y) {
    const line = y * (stride + 1);
    const filter = FILTERS[coded[line] ?? 0] ?? (() => 0);
    for (let k = 0; k < stride; ++k) {
      const back = k - channels;
      const more = filter(byte(y, back), byte(y - 1, k), byte(y - 1, back));
      bytes[y * stride + k] = ((coded[line + 1 + k] ?? 0) + more) & 255;
    }
  }
  const at = (x: number, y: number): readonly [number, number, number] => {
    const k = channels * x;
    return [byte(y, k), byte(y, k + 1), byte(y, k + 2)];
  };
  return { width, height, at };
}

/** Pictures once they stay as they are. */
export async function steady(take: () => Promise<Buffer[]>): Promise<Buffer[]> {
  let before = await take();
  const stays = async (): Promise<boolean> => {
    const now = await take();
    const same = now.every((picture, k) => picture.equals(before[k] ?? Buffer.of()));
    before = now;
    return same;
  };
  await expect.poll(stays, { interval: 200 }).toBe(true);
  return before;
}
