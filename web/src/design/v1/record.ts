// SPDX-License-Identifier: MIT
// Frozen: what autosave kept before it kept objects, of a tab (PLNS) and of each step of its history (PLNH):
//   magic (4 bytes) | version (4) | CRC-32 of the rest (4) | length of the JSON (4) | JSON | float64s
// little-endian. In the JSON a run [first, count] stands for some of these numbers.

import { crc32 } from "../../bytes/crc32.ts";
import type { Unit } from "../../quantity/units.ts";
import type { FileFormat } from "../../solver/file-formats.ts";
import type { Planarising, Shape, ShapeReport, Source } from "../../solver/protocol.ts";
import { type Design, type Family, NO_REPORT, type Variation } from "../design.ts";
import { readGroups } from "../groups.ts";
import { NEAREST_FLAT } from "../planarising.ts";
import { readCamera } from "../reading.ts";
import { type KeptFiles, keptFile } from "../saved-design.ts";
import type { ReadRecord, SavedRecord } from "../saved-record.ts";
import { readSection } from "../section-plane.ts";
import { readHandles, readSettings, readWeights } from "./settings.ts";

const HEADER = 16;
const RECORD = 0x534e4c50;
const STEP = 0x484e4c50;

type Run = readonly [number, number];

interface PackedFamily {
  readonly x: Run;
  readonly asked: number;
  readonly eigenbasis: boolean;
  readonly weights?: unknown;
}

interface PackedDesign {
  readonly source: [string, number] | [string, FileFormat, number, number];
  /** At first whether. */
  readonly planarised: boolean | null | Partial<Planarising>;
  readonly handles: Run;
  readonly settings: unknown;
  readonly shape: [Run, Run];
  readonly report: Partial<ShapeReport>;
  readonly variation:
    | (PackedFamily & { centre: [Run, Run]; earlier: PackedFamily[]; exact: boolean })
    | null;
}

interface PackedRecord extends Pick<SavedRecord, "time"> {
  readonly unit: Unit;
  readonly camera: unknown;
  readonly present: PackedDesign;
  readonly snapshots: { id: string; name: string; time: number; picture: string; design: never }[];
  // What later pages added.
  readonly figure?: string | null;
  readonly views?: { name: string; camera: unknown }[];
  readonly note?: string;
  readonly section?: unknown;
  readonly groups?: unknown;
  readonly steps?: SavedRecord["steps"];
}

/** What is not there. */
class Missing extends Error {}

function insist<T>(value: T | null | undefined): T {
  if (value === null || value === undefined) throw new Missing();
  return value;
}

/** Reads one block; what it throws is damage. */
class Block {
  readonly json: unknown;
  readonly #numbers: Float64Array;
  readonly #files: KeptFiles;

  constructor(bytes: Uint8Array, end: number, files: KeptFiles) {
    this.json = JSON.parse(
      new TextDecoder("utf-8", { fatal: true }).decode(bytes.slice(HEADER, end)),
    );
    this.#numbers = new Float64Array(bytes.slice(end, end + ((bytes.length - end) & ~7)).buffer);
    this.#files = files;
  }

  #run([first, count]: Run): Float64Array {
    if (!(first >= 0 && first + count <= this.#numbers.length)) throw new Missing();
    return this.#numbers.slice(first, first + count);
  }

  #shape([moved, positions]: [Run, Run]): Shape {
    return { moved: Int32Array.from(this.#run(moved)), positions: this.#run(positions) };
  }

  #source([name, second, crc = 0, size = 0]: PackedDesign["source"]): Source {
    if (typeof second === "number") return { kind: "sample", name, size: second };
    return {
      kind: "file",
      name,
      format: second,
      bytes: insist(keptFile(this.#files, { crc, size })),
      crc,
    };
  }

  #family({ x, asked, eigenbasis, weights }: PackedFamily): Family {
    return { coefficients: [...this.#run(x)], asked, eigenbasis, ...insist(readWeights(weights)) };
  }

  #variation(packed: PackedDesign["variation"]): Variation | null {
    if (!packed) return null;
    const { centre, exact } = packed;
    const earlier = packed.earlier.map((family) => this.#family(family));
    return { ...this.#family(packed), centre: this.#shape(centre), earlier, exact };
  }

  design({ source, planarised, settings, report, ...packed }: PackedDesign): Design {
    const flat = this.#run(packed.handles);
    const rows = Array.from({ length: flat.length / 5 }, (_, k) => [
      ...flat.slice(5 * k, 5 * k + 5),
    ]);
    return {
      source: this.#source(source),
      planarised: planarised
        ? { ...NEAREST_FLAT, ...(planarised === true ? {} : planarised) }
        : null,
      handles: insist(readHandles(rows)),
      settings: insist(readSettings(settings)),
      shape: this.#shape(packed.shape),
      report: readReport(report),
      variation: this.#variation(packed.variation),
    };
  }
}

/** JSON has null for a figure that is not known. */
function readReport(report: Partial<ShapeReport>): ShapeReport {
  const known = Object.entries({ worstExcess: report.worstMmPerM, ...report }).map(
    ([name, value]) => [name, value === null && name !== "sharpestFold" ? Number.NaN : value],
  );
  return { ...NO_REPORT, ...Object.fromEntries(known) };
}

/** @param read what is made of a whole block */
function unpack<T>(
  magic: number,
  bytes: Uint8Array,
  files: KeptFiles,
  read: (block: Block) => T,
): T | "newer" | "damaged" {
  if (bytes.length < HEADER) return "damaged";
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(0, true) !== magic) return "damaged";
  if (view.getUint32(4, true) > 1) return "newer";
  const whole = view.getUint32(8, true) === crc32(bytes.subarray(12));
  try {
    return whole ? read(new Block(bytes, HEADER + view.getUint32(12, true), files)) : "damaged";
  } catch {
    return "damaged";
  }
}

function readBlock(block: Block): SavedRecord {
  const { time, unit, camera, present, snapshots, ...more } = block.json as PackedRecord;
  const views = (more.views ?? []).flatMap(({ name, camera: numbers }) => {
    const camera = readCamera(numbers);
    return camera ? [{ name, camera }] : [];
  });
  return {
    time,
    unit,
    camera: readCamera(camera) ?? null,
    figure: more.figure ?? null,
    present: block.design(present),
    snapshots: snapshots.map(({ design, ...one }) => ({ ...one, design: block.design(design) })),
    views: [...new Map(views.map((one) => [one.name, one])).values()],
    note: more.note ?? "",
    section: readSection(more.section),
    groups: Array.isArray(more.groups) ? readGroups(more.groups) : null,
    steps: more.steps ?? { past: [], future: [] },
  };
}

export function decodeRecord(bytes: Uint8Array, files: KeptFiles): ReadRecord {
  const read = unpack(RECORD, bytes, files, readBlock);
  return typeof read === "string" ? { kind: read } : { kind: "record", record: read };
}

/** null where it is damaged. */
export function decodeStep(bytes: Uint8Array, files: KeptFiles): Design | null {
  const step = (block: Block) => block.design((block.json as { design: PackedDesign }).design);
  const read = unpack(STEP, bytes, files, step);
  return typeof read === "string" ? null : read;
}
