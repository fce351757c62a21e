// SPDX-License-Identifier: MIT
// What is drawn on a sheet can be cut from it: every piece lies on the sheet, and apart from the others.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { inflateRawSync } from "node:zlib";
import { afterAll, beforeAll, expect, it } from "vitest";

const CLI = new URL("../../build/native/planish", import.meta.url).pathname;
const [WIDTH, HEIGHT] = [6000, 3000];
/** Millimetres; numbers in a drawing have six digits after the point. */
const ROUNDING = 1e-5;

let folder: string;
beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), "planish-sheets-"));
});
afterAll(() => rmSync(folder, { recursive: true }));

type Place = readonly [x: number, y: number];
type Piece = readonly Place[];

/** The files of an archive whose names match. */
function filesIn(zip: Buffer, wanted: RegExp): string[] {
  const found: string[] = [];
  for (let at = zip.readUInt32LE(zip.length - 6); zip.readUInt32LE(at) === 0x02014b50; ) {
    const [method, packed] = [zip.readUInt16LE(at + 10), zip.readUInt32LE(at + 20)];
    const [name, extra, comment] = [28, 30, 32].map((k) => zip.readUInt16LE(at + k));
    const local = zip.readUInt32LE(at + 42);
    const begin = local + 30 + zip.readUInt16LE(local + 26) + zip.readUInt16LE(local + 28);
    if (wanted.test(zip.toString("utf8", at + 46, at + 46 + (name ?? 0)))) {
      const bytes = zip.subarray(begin, begin + packed);
      found.push((method === 0 ? bytes : inflateRawSync(bytes)).toString());
    }
    at += 46 + (name ?? 0) + (extra ?? 0) + (comment ?? 0);
  }
  return found;
}

const piecesOf = (svg: string): Piece[] =>
  [...svg.matchAll(/<polygon class="CUT" points="([^"]+)"/g)].map(([, points = ""]) =>
    points.split(" ").map((point) => {
      const [x = Number.NaN, y = Number.NaN] = point.split(",").map(Number);
      return [x, y];
    }),
  );

/** By how much a line along a side of either parts two convex pieces; negative: none does. */
function gap(a: Piece, b: Piece): number {
  let widest = Number.NEGATIVE_INFINITY;
  for (const piece of [a, b])
    for (const [k, [x, y]] of piece.entries()) {
      const [u, v] = piece.at(k - 1) ?? [x, y];
      const length = Math.hypot(y - v, x - u);
      const along = ([p, q]: Place): number => (p * (y - v) - q * (x - u)) / length;
      const [ours, theirs] = [a.map(along), b.map(along)];
      widest = Math.max(widest, Math.min(...theirs) - Math.max(...ours));
      widest = Math.max(widest, Math.min(...ours) - Math.max(...theirs));
    }
  return widest;
}

it.each(["vault", "hex", "trihex"])("of a %s", (sample) => {
  const words = `panels sample:${sample}:7 -o p.zip --sheet ${WIDTH}x${HEIGHT}`;
  execFileSync(CLI, words.split(" "), { cwd: folder });
  const sheets = filesIn(readFileSync(join(folder, "p.zip")), /^sheets\/.*\.svg$/).map(piecesOf);
  expect(sheets.flat().length).toBeGreaterThan(15);
  for (const pieces of sheets) {
    expect(pieces.length).toBeGreaterThan(0);
    for (const [k, piece] of pieces.entries()) {
      for (const [x, y] of piece) {
        expect(Math.min(x, y)).toBeGreaterThanOrEqual(0);
        expect(x).toBeLessThanOrEqual(WIDTH);
        expect(y).toBeLessThanOrEqual(HEIGHT);
      }
      for (const other of pieces.slice(k + 1)) expect(gap(piece, other)).toBeGreaterThan(-ROUNDING);
    }
  }
});
