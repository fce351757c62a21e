// SPDX-License-Identifier: MIT
// One design in the browser's storage, which keeps objects and typed arrays as they are. The file that it
// came from is kept beside it, once.

import type { Shape, Source } from "../solver/protocol.ts";
import { DEFAULT_SETTINGS, type Design, NO_REPORT, type Variation } from "./design.ts";

/** What is kept beside a record, by key: files and steps of the history. */
export type KeptFiles = ReadonlyMap<string, unknown>;

type FileSource = Extract<Source, { kind: "file" }>;
type Sample = Exclude<Source, FileSource>;

/** By what a kept file is found. */
interface FileMark {
  readonly crc: number;
  readonly size: number;
}

type StoredSource = Sample | (Omit<FileSource, "bytes"> & FileMark);

export interface StoredDesign extends Omit<Design, "source"> {
  readonly source: StoredSource;
}

const keyOf = ({ crc, size }: FileMark): string => `${crc.toString(16)}-${size}`;

export const fileKey = ({ crc, bytes }: Pick<FileSource, "crc" | "bytes">): string =>
  keyOf({ crc, size: bytes.size });

/** null if it is not there. */
export function keptFile(files: KeptFiles, mark: FileMark): Blob | null {
  const file = files.get(keyOf(mark));
  return file instanceof Blob ? file : null;
}

/** A shape without the memory that its arrays may be a part of, which would be kept whole. */
const apart = ({ moved, positions }: Shape): Shape => ({
  moved: moved.slice(),
  positions: positions.slice(),
});

const variationApart = (variation: Variation): Variation => ({
  ...variation,
  centre: apart(variation.centre),
});

export function storeDesign({ source, shape, report, variation, ...rest }: Design): StoredDesign {
  const { kind } = source;
  return {
    ...rest,
    source:
      kind === "sample"
        ? source
        : {
            kind,
            name: source.name,
            format: source.format,
            crc: source.crc,
            size: source.bytes.size,
          },
    shape: apart(shape),
    // A certificate is of a solve, not of a record.
    report: { ...report, residuals: [], optimality: {} },
    variation: variation && variationApart(variation),
  };
}

/** null if its file is not there. What is newer than the record is as usual. */
export function restoreDesign(stored: StoredDesign, files: KeptFiles): Design | null {
  const { source: kept, settings, report } = stored;
  const bytes = kept.kind === "file" ? keptFile(files, kept) : null;
  if (kept.kind === "file" && !bytes) return null;
  const source: Source =
    kept.kind === "file" && bytes
      ? { kind: "file", name: kept.name, format: kept.format, bytes, crc: kept.crc }
      : (kept as Sample);
  return {
    ...stored,
    source,
    settings: { ...DEFAULT_SETTINGS, ...settings },
    report: { ...NO_REPORT, ...report },
  };
}
