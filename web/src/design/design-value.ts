// SPDX-License-Identifier: MIT
// A recipe as the core's design, which it replays, reads and writes. The core says what is wrong with
// a text; here is only what the page cannot show of a design that is right.

import { crc32 } from "../bytes/crc32.ts";
import { isUnit } from "../quantity/units.ts";
import { type Result, refuse } from "../result/result.ts";
import { namesOfFormats } from "../solver/file-formats.ts";
import type { DesignReading, DesignValue, Source } from "../solver/protocol.ts";
import type { HandleRow } from "./design.ts";
import { toTargets } from "./design.ts";
import { readKept } from "./kept-kind.ts";
import { readFormat } from "./reading.ts";
import type { Steps } from "./recipe.ts";
import { readLimits } from "./stated-limit.ts";

/** What is read: a recipe, and what its source says. */
export interface DesignText extends Omit<Steps, "source" | "camera"> {
  /** null if the mesh lies beside the design. */
  readonly source: Source | null;
  /** The name of the mesh's file; "" for a sample. */
  readonly meshName: string;
}

const NO_BYTES = new Uint8Array(0);

/** @param bytes of the mesh's file, to ride along */
export function toDesign(recipe: Steps, bytes: Uint8Array = NO_BYTES): DesignValue {
  const { source, planarised, unit, settings, families, mark, baseHash } = recipe;
  const { supports, continuation, symmetry, cuts, ...options } = settings;
  // Making a mesh flat, or symmetric, may round differently elsewhere.
  const asOpened = planarised === null && symmetry.length === 0;
  const hash = asOpened ? (baseHash ?? null) : null;
  return {
    source:
      source.kind === "sample"
        ? { sample: source.name, size: source.size }
        : { file: source.name, hash, format: source.format, bytes },
    planarised,
    unit,
    ...toTargets(recipe.handles),
    supports,
    continuation,
    symmetry,
    cuts,
    options,
    variations: families,
    result: mark,
  };
}

/** The core's clauses as sentences. */
const sentence = (clause: string): string => (/[.!]$/.test(clause) ? clause : `${clause}.`);

type Read = NonNullable<DesignReading["design"]>;

/** What the page has no control for, in words; null if it can show all. */
function whatIsUnknown(design: Read): string | null {
  const { options, variations, planarised, source } = design;
  if (!readLimits(options.limits)) return "options.bounds: this page knows each limit once.";
  const kinds = "this page knows the kinds circular and conical, each once.";
  if (!readKept(options.constraints)) return `options.constraints: ${kinds}`;
  if (!readKept(planarised?.constraints ?? [])) return `planarised.constraints: ${kinds}`;
  const other = variations.findIndex(({ plain }) => !plain);
  if (other >= 0)
    return `variations[${other}] is one that only the command line can show: not exact, or about other points.`;
  if ("bytes" in source && source.bytes.length > 0 && !readFormat(source.format))
    return `source.format must be ${namesOfFormats().toLowerCase()}.`;
  return null;
}

function handlesOf({ handles, pins }: Read): HandleRow[] {
  const rows: HandleRow[] = [];
  for (let k = 0; k + 3 < handles.length; k += 4) {
    const [vertex = 0, x = 0, y = 0, z = 0] = handles.slice(k, k + 4);
    rows.push({ vertex, target: [x, y, z], pinned: false });
  }
  return [...rows, ...pins.map((vertex) => ({ vertex, target: [0, 0, 0], pinned: true }) as const)];
}

function sourceOf({ source }: Read): Pick<DesignText, "source" | "meshName" | "baseHash"> {
  if ("sample" in source) {
    const { sample: name, size } = source;
    return { source: { kind: "sample", name, size }, meshName: "", baseHash: null };
  }
  const { file: name, bytes } = source;
  const format = readFormat(source.format);
  const found = { meshName: name, baseHash: source.hash };
  if (!format || bytes.length === 0) return { ...found, source: null };
  const kept = new Blob([bytes as BlobPart]);
  return { ...found, source: { kind: "file", name, format, bytes: kept, crc: crc32(bytes) } };
}

/** The recipe that was read, or one sentence. */
export function fromDesign({ problem, design }: DesignReading): Result<DesignText> {
  if (!design) return refuse(sentence(problem));
  const { planarised, unit, options, supports, continuation, symmetry, cuts } = design;
  const { variations, result: mark } = design;
  const unknown = whatIsUnknown(design);
  if (unknown !== null || !isUnit(unit)) return refuse(unknown ?? "unit must be known.");
  const value: DesignText = {
    ...sourceOf(design),
    planarised,
    unit,
    handles: handlesOf(design),
    settings: { ...options, supports, continuation, symmetry, cuts },
    families: variations.map(({ plain: _, ...family }) => family),
    mark,
    someSliders: true,
  };
  return { ok: true, value };
}
