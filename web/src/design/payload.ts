// SPDX-License-Identifier: MIT
// The bytes inside a link of version 1:
//   CRC-32 of the rest (4 bytes) | length of the JSON (4 bytes) | JSON | the file, if any
// little-endian. Links are kept readable for ever: what is added may be missing, and a change of
// layout is a new version.

import { crc32 } from "../bytes/crc32.ts";
import { isUnit } from "../quantity/units.ts";
import type { FileFormat, Planarising, ResultMark, Source } from "../solver/protocol.ts";
import type { Family } from "./design.ts";
import { readKept } from "./kept-kind.ts";
import { isNearestFlat, NEAREST_FLAT } from "./planarising.ts";
import {
  isIndex,
  isName,
  isNumbers,
  isRecord,
  type Json,
  MOST_DIRECTIONS,
  readCamera,
  readFormat,
  readHandles,
  readSettings,
  readWeights,
  WEIGHT_COUNT,
  writeCamera,
  writeSettings,
  writeWeights,
} from "./reading.ts";
import type { Recipe } from "./recipe.ts";

const HEADER = 8;
/** Vertex, x, y, z for each recorded point. */
const MOST_PROBES = 4 * 64;
const MOST_FAMILIES = 100;

/** The JSON of version 1. Short names: they are part of every link. */
interface Payload {
  /** Sample name and size, or file name and format. */
  s: [string, number] | [string, FileFormat];
  /** Whether its mesh was planarised; then the weight of fairness, the boundary and the
   * shape kept, and kinds of constraints if there are any; then how far points may go and how far
   * panels stay out of flat, if they do. */
  p:
    | 0
    | 1
    | [number, 0 | 1, 0 | 1]
    | [number, 0 | 1, 0 | 1, readonly string[]]
    | [number, 0 | 1, 0 | 1, readonly string[], number, number];
  h: [number, number, number, number, 0 | 1][];
  /** By the PLACES of reading.ts. */
  w: readonly unknown[];
  x: readonly number[] | null;
  /**
   * Directions asked for, and whether by stiffness (1) and by weights that follow (2); without it as
   * many as `x` has, not.
   */
  d?: number[];
  /** Families before that of `x`: what `d` says, then the coefficients. */
  e?: number[][];
  u: string;
  /** Camera: position and target. */
  c?: number[];
  r: [number, number, readonly number[]];
}

const BY_STIFFNESS = 1;
const BY_WEIGHTS = 2;

const howFound = ({ asked, eigenbasis, weights }: Family): number[] => [
  asked,
  (eigenbasis ? BY_STIFFNESS : 0) + (weights ? BY_WEIGHTS : 0),
  ...(weights ? writeWeights(weights) : []),
];

function toPayload(recipe: Recipe): Payload {
  const { source, handles, families, mark, camera } = recipe;
  const variation = families.at(-1);
  const earlier = families.slice(0, -1);
  return {
    s: source.kind === "sample" ? [source.name, source.size] : [source.name, source.format],
    p: writePlanarising(recipe.planarised),
    h: handles.map(({ vertex, target, pinned }) => [vertex, ...target, pinned ? 1 : 0]),
    w: writeSettings(recipe.settings),
    x: variation?.coefficients ?? null,
    ...(variation && { d: howFound(variation) }),
    ...(earlier.length > 0 && {
      e: earlier.map((family) => [...howFound(family), ...family.coefficients]),
    }),
    u: recipe.unit,
    ...(camera && { c: writeCamera(camera) }),
    r: [mark.hash, mark.moved, mark.probes],
  };
}

/** 1 is the nearest flat mesh, which links of earlier versions mean by it. */
function writePlanarising(how: Planarising | null): Payload["p"] {
  if (!how) return 0;
  if (isNearestFlat(how)) return 1;
  const flags = [how.keepBoundary ? 1 : 0, how.keepShape ? 1 : 0] as const;
  const { smooth, constraints, within, flat } = how;
  if (within > 0 || flat > 0) return [smooth, ...flags, constraints, within, flat];
  return constraints.length > 0 ? [smooth, ...flags, constraints] : [smooth, ...flags];
}

/** undefined if it is neither. */
function readPlanarising(value: unknown): Planarising | null | undefined {
  if (!Array.isArray(value)) return value === 1 ? NEAREST_FLAT : null;
  const numbers: unknown[] = value.slice(0, 3);
  const constraints = readKept(value[3] ?? []);
  const bounds: unknown[] = value.length > 4 ? value.slice(4) : [0, 0];
  if (!isNumbers(numbers, 3) || !isNumbers(bounds, 2) || !constraints) return undefined;
  const [smooth = 0, boundary, shape] = numbers;
  const [within = 0, flat = 0] = bounds;
  if (smooth < 0 || within < 0 || flat < 0) return undefined;
  const kept = { keepBoundary: boundary === 1, keepShape: shape === 1 };
  return { smooth, ...kept, constraints, within, flat };
}

export async function encodePayload(recipe: Recipe): Promise<Uint8Array> {
  const { source } = recipe;
  const json = new TextEncoder().encode(JSON.stringify(toPayload(recipe)));
  const file =
    source.kind === "file" ? new Uint8Array(await source.bytes.arrayBuffer()) : new Uint8Array(0);
  const bytes = new Uint8Array(HEADER + json.length + file.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(4, json.length, true);
  bytes.set(json, HEADER);
  bytes.set(file, HEADER + json.length);
  view.setUint32(0, crc32(bytes.subarray(4)), true);
  return bytes;
}

function readSource(value: unknown, file: Uint8Array): Source | null {
  if (!Array.isArray(value) || value.length !== 2) return null;
  const [name, second] = value as [unknown, unknown];
  if (!isName(name)) return null;
  if (isIndex(second)) return { kind: "sample", name, size: second };
  const format = readFormat(second);
  if (!format) return null;
  const bytes = new Blob([file as BlobPart]);
  return { kind: "file", name, format, bytes, crc: crc32(file) };
}

/** @param all how it was found, then the coefficients */
function readFamily(all: unknown): Family | null {
  if (!isNumbers(all)) return null;
  const [asked, flags = 0] = all;
  const weighted = flags >= BY_WEIGHTS;
  const start = 2 + (weighted ? WEIGHT_COUNT : 0);
  const coefficients = all.slice(start);
  if (coefficients.length === 0 || !isIndex(asked)) return null;
  if (asked < coefficients.length || asked > MOST_DIRECTIONS) return null;
  const weights = readWeights(weighted ? all.slice(2, start) : undefined);
  return weights && { coefficients, asked, eigenbasis: flags % 2 === BY_STIFFNESS, ...weights };
}

/** null if they are not families; earlier ones make no sense without the last. */
function readFamilies({ x, d, e = [] }: Json): Family[] | null {
  if (!Array.isArray(e) || e.length > MOST_FAMILIES) return null;
  if (x === null) return e.length === 0 ? [] : null;
  if (!isNumbers(x)) return null;
  const how: unknown = d === undefined ? [x.length, 0] : d;
  if (!isNumbers(how) || how.length < 2) return null;
  const all: Family[] = [];
  for (const value of [...e, [...how, ...x]]) {
    const family = readFamily(value);
    if (!family) return null;
    all.push(family);
  }
  return all;
}

function readMark(value: unknown): ResultMark | null {
  if (!Array.isArray(value) || value.length !== 3) return null;
  const [hash, moved, probes] = value as unknown[];
  if (!isIndex(hash) || !isIndex(moved) || !isNumbers(probes)) return null;
  return probes.length % 4 === 0 && probes.length <= MOST_PROBES ? { hash, moved, probes } : null;
}

function readPayload(payload: Json, file: Uint8Array): Recipe | null {
  const source = readSource(payload.s, file);
  const handles = readHandles(payload.h);
  const settings = readSettings(payload.w);
  const families = readFamilies(payload);
  const mark = readMark(payload.r);
  const camera = readCamera(payload.c);
  const planarised = readPlanarising(payload.p);
  const { u: unit } = payload;
  if (!source || !handles || !settings || !mark) return null;
  if (!families || camera === undefined || planarised === undefined) return null;
  if (typeof unit !== "string" || !isUnit(unit)) return null;
  return { source, planarised, handles, settings, families, unit, camera, mark };
}

/** null if the bytes are not a whole, unchanged recipe. */
export function decodePayload(bytes: Uint8Array): Recipe | null {
  if (bytes.length < HEADER) return null;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const end = HEADER + view.getUint32(4, true);
  if (end > bytes.length || view.getUint32(0, true) !== crc32(bytes.subarray(4))) return null;
  try {
    const text = new TextDecoder("utf-8", { fatal: true }).decode(bytes.subarray(HEADER, end));
    const payload: unknown = JSON.parse(text);
    return isRecord(payload) ? readPayload(payload, bytes.slice(end)) : null;
  } catch {
    return null;
  }
}
