// SPDX-License-Identifier: MIT
// One design inside a saved record: words in JSON, every number that must come back in float64.

import type { PoolReader, PoolWriter } from "../bytes/number-pool.ts";
import type { Planarising, Shape, ShapeReport, Source } from "../solver/protocol.ts";
import type { Design, Family, HandleRow, Variation } from "./design.ts";
import { readKept } from "./kept-kind.ts";
import { NEAREST_FLAT } from "./planarising.ts";
import {
  isIndex,
  isName,
  isNumber,
  isNumbers,
  isRecord,
  type Json,
  readFormat,
} from "./reading.ts";
import { writeSettings, writeWeights } from "./saved-settings.ts";
import { readHandles, readSettings, readWeights } from "./v1/settings.ts";

/** The solver's own limit. */
const MOST_DIRECTIONS = 24;

/** Kept files by fileKey(). */
export type Files = ReadonlyMap<string, Blob>;

type FileSource = Extract<Source, { kind: "file" }>;

export const fileKey = ({ crc, bytes }: Pick<FileSource, "crc" | "bytes">): string =>
  `${crc.toString(16)}-${bytes.size}`;

const STATUS = /^[a-z_]{1,40}$/;
const NO_NAME = "unknown";

function writeSource(source: Source): unknown[] {
  if (source.kind === "sample") return [source.name, source.size];
  return [source.name, source.format, source.crc, source.bytes.size];
}

const writeShape = ({ moved, positions }: Shape, pool: PoolWriter): unknown[] => [
  pool.add(moved),
  pool.add(positions),
];

const writeRow = ({ vertex, target, pinned }: HandleRow): number[] => [
  vertex,
  ...target,
  pinned ? 1 : 0,
];

const writeFamily = (family: Family, pool: PoolWriter): Json => ({
  x: pool.add(family.coefficients),
  asked: family.asked,
  eigenbasis: family.eigenbasis,
  ...(family.weights && { weights: writeWeights(family.weights) }),
});

function writeVariation(variation: Variation, pool: PoolWriter): unknown {
  const { centre, exact, earlier } = variation;
  return {
    ...writeFamily(variation, pool),
    earlier: earlier.map((family) => writeFamily(family, pool)),
    centre: writeShape(centre, pool),
    exact,
  };
}

export function writeDesign(design: Design, pool: PoolWriter): unknown {
  const { source, planarised, handles, settings, shape, report, variation } = design;
  return {
    source: writeSource(source),
    planarised,
    handles: pool.add(handles.flatMap(writeRow)),
    settings: writeSettings(settings),
    shape: writeShape(shape, pool),
    report: { ...report, residuals: [] },
    variation: variation && writeVariation(variation, pool),
  };
}

function readSource(value: unknown, files: Files): Source | null {
  if (!Array.isArray(value)) return null;
  const [name, second, crc, size] = value as unknown[];
  if (!isName(name)) return null;
  if (value.length === 2 && isIndex(second)) return { kind: "sample", name, size: second };
  const format = readFormat(second);
  if (value.length !== 4 || !format || !isIndex(crc) || !isIndex(size)) return null;
  const bytes = files.get(`${crc.toString(16)}-${size}`);
  return bytes ? { kind: "file", name, format, bytes, crc } : null;
}

function readShape(value: unknown, pool: PoolReader): Shape | null {
  if (!Array.isArray(value) || value.length !== 2) return null;
  const moved = pool.at(value[0]);
  const positions = pool.at(value[1]);
  if (!moved || !positions || positions.length !== 3 * moved.length) return null;
  const ascending = moved.every((v, k) => isIndex(v) && v < 2 ** 31 && v > (moved[k - 1] ?? -1));
  if (!ascending || !positions.every((x) => Number.isFinite(x))) return null;
  return { moved: Int32Array.from(moved), positions };
}

/** A figure may be unknown, which JSON writes as null. */
const readFigure = (value: unknown): number => (isNumber(value) ? value : Number.NaN);

function readFold(value: unknown): ShapeReport["sharpestFold"] {
  if (!isRecord(value)) return null;
  const { before, after } = value;
  return isNumber(before) && isNumber(after) ? { before, after } : null;
}

function readMotion(value: unknown): Pick<ShapeReport, "motion"> {
  if (!isRecord(value)) return {};
  const { raised, lowered, slide } = value;
  const known = isNumber(raised) && isNumber(lowered) && isNumber(slide);
  return known ? { motion: { raised, lowered, slide } } : {};
}

function readReport(value: unknown): ShapeReport | null {
  if (!isRecord(value)) return null;
  const { status, movedVertices } = value;
  if (!isIndex(movedVertices)) return null;
  return {
    status: typeof status === "string" && STATUS.test(status) ? status : NO_NAME,
    movedVertices,
    maxDisplacement: readFigure(value.maxDisplacement),
    ...readMotion(value.motion),
    worstGap: readFigure(value.worstGap),
    worstMmPerM: readFigure(value.worstMmPerM),
    // Records from before this figure was kept.
    worstExcess: readFigure(value.worstExcess ?? value.worstMmPerM),
    sharpestFold: readFold(value.sharpestFold),
    handleError: readFigure(value.handleError),
    objective: readFigure(value.objective),
    iterations: readFigure(value.iterations),
    seconds: readFigure(value.seconds),
    residuals: [],
    optimality: {}, // not kept: a certificate is of a solve, not of a record
  };
}

function readFamily(value: unknown, pool: PoolReader): Family | null {
  if (!isRecord(value)) return null;
  const { asked, eigenbasis } = value;
  const coefficients = Array.from(pool.at(value.x) ?? []);
  if (coefficients.length === 0 || !isNumbers(coefficients)) return null;
  if (!isIndex(asked) || asked < coefficients.length || asked > MOST_DIRECTIONS) return null;
  const weights = readWeights(value.weights);
  return weights && typeof eigenbasis === "boolean"
    ? { coefficients, asked, eigenbasis, ...weights }
    : null;
}

function readVariation(value: unknown, pool: PoolReader): Variation | null | undefined {
  if (value === null) return null;
  if (!isRecord(value) || !Array.isArray(value.earlier)) return undefined;
  const family = readFamily(value, pool);
  const centre = readShape(value.centre, pool);
  const { exact } = value;
  if (!family || !centre || typeof exact !== "boolean") return undefined;
  const earlier: Family[] = [];
  for (const item of value.earlier) {
    const one = readFamily(item, pool);
    if (!one) return undefined;
    earlier.push(one);
  }
  return { ...family, centre, earlier, exact };
}

/** Five numbers a row. */
function rowsOf(numbers: Float64Array | null): number[][] | null {
  if (!numbers || numbers.length % 5 !== 0) return null;
  return Array.from({ length: numbers.length / 5 }, (_, k) =>
    Array.from(numbers.subarray(5 * k, 5 * k + 5)),
  );
}

/** undefined if it is neither; older ones only say whether. */
function readPlanarising(value: unknown): Planarising | null | undefined {
  if (value === null || value === false) return null;
  if (value === true) return NEAREST_FLAT;
  if (!isRecord(value)) return undefined;
  const { smooth, keepBoundary, keepShape, within = 0, flat = 0 } = value;
  const constraints = readKept(value.constraints ?? []);
  const weight = (x: unknown): x is number => typeof x === "number" && x >= 0;
  if (!weight(smooth) || !weight(within) || !weight(flat) || !constraints) return undefined;
  return {
    smooth,
    keepBoundary: keepBoundary === true,
    keepShape: keepShape === true,
    constraints,
    within,
    flat,
  };
}

/** null if it is not a whole design, or if its file is not there. */
export function readDesign(value: unknown, pool: PoolReader, files: Files): Design | null {
  if (!isRecord(value)) return null;
  const source = readSource(value.source, files);
  const handles = readHandles(rowsOf(pool.at(value.handles)));
  const settings = readSettings(value.settings);
  const shape = readShape(value.shape, pool);
  const report = readReport(value.report);
  const variation = readVariation(value.variation, pool);
  const planarised = readPlanarising(value.planarised);
  if (!source || !handles || !settings || !shape || !report) return null;
  if (variation === undefined || planarised === undefined) return null;
  if (report.movedVertices !== shape.moved.length) return null;
  return { source, planarised, handles, settings, shape, report, variation };
}
