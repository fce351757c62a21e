// SPDX-License-Identifier: MIT
// Files come in pieces, so that progress can be shown; a copy that the page keeps is checked.

import { crc32 } from "../bytes/crc32.ts";
import type { FileFormat } from "./file-formats.ts";
import type { Source } from "./protocol.ts";

type FileSource = Extract<Source, { kind: "file" }>;
export type OnPiece = (done: number, total: number) => void;

/** Bytes between two reports. */
const PIECE = 4 * 1024 * 1024;

/** The whole content; throws a sentence if the file has become unreadable. */
async function readAll(file: Blob, onPiece: OnPiece): Promise<Uint8Array> {
  const bytes = new Uint8Array(file.size);
  const reader = file.stream().getReader();
  let at = 0;
  for (let told = 0; ; ) {
    const { done, value } = await reader.read();
    if (done) break;
    if (at + value.length > bytes.length) throw new Error("The file changed while it was read.");
    bytes.set(value, at);
    at += value.length;
    if (at - told < PIECE) continue;
    told = at;
    onPiece(at, bytes.length);
  }
  if (at !== bytes.length) throw new Error("The file changed while it was read.");
  return bytes;
}

/** A reader says what is wrong and on which line, which a Rhino file has not; this makes it a sentence
 * about the file. */
export function aboutFile(name: string, what: string): string {
  const said = /\.3dm$/i.test(name) ? what.replace(/^line \d+: /, "") : what;
  return `${name}: ${said.endsWith(".") ? said : `${said}.`}`;
}

/** The copy of a file that the page keeps. */
export function keepCopy(name: string, format: FileFormat, bytes: Uint8Array): FileSource {
  const kept = new Blob([bytes as BlobPart]);
  return { kind: "file", name, format, bytes: kept, crc: crc32(bytes) };
}

/** Reads a user's file. */
export const readGiven = (file: Blob, name: string, onPiece: OnPiece): Promise<Uint8Array> =>
  readAll(file, onPiece).catch(() => {
    throw new Error(`${name} could not be read. Open it again.`);
  });

/** Reads a user's file and makes the copy that the page keeps. */
export async function readFile(
  file: Blob,
  name: string,
  format: FileFormat,
  onPiece: OnPiece,
): Promise<{ source: FileSource; bytes: Uint8Array }> {
  const bytes = await readGiven(file, name, onPiece);
  return { source: keepCopy(name, format, bytes), bytes };
}

/** Reads a copy that the page kept; throws a sentence if it is not what was kept. */
export async function readKept(source: FileSource, onPiece: OnPiece): Promise<Uint8Array> {
  const damaged = (): never => {
    throw new Error(`The stored copy of ${source.name} is damaged. Open the file again.`);
  };
  const bytes = await readAll(source.bytes, onPiece).catch(damaged);
  return crc32(bytes) === source.crc ? bytes : damaged();
}
