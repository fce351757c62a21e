// SPDX-License-Identifier: MIT
// What was done to a mesh, as it stands in the JSON of a link: of the design, and of its variants.

import type { Planarising, ResultMark } from "../solver/protocol.ts";
import type { Family } from "./design.ts";
import { readKept } from "./kept-kind.ts";
import type { MarkedSteps } from "./marked-steps.ts";
import { isNearestFlat, NEAREST_FLAT } from "./planarising.ts";
import {
  isIndex,
  isNumbers,
  type Json,
  MOST_DIRECTIONS,
  readHandles,
  readSettings,
  readWeights,
  WEIGHT_COUNT,
  writeSettings,
  writeWeights,
} from "./reading.ts";

/** Vertex, x, y, z for each recorded point. */
const MOST_PROBES = 4 * 64;
const MOST_FAMILIES = 100;

/** Short names: they are part of every link. */
export interface StepsJson {
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
  r: [number, number, readonly number[]];
}

const BY_STIFFNESS = 1;
const BY_WEIGHTS = 2;

const howFound = ({ asked, eigenbasis, weights }: Family): number[] => [
  asked,
  (eigenbasis ? BY_STIFFNESS : 0) + (weights ? BY_WEIGHTS : 0),
  ...(weights ? writeWeights(weights) : []),
];

/** 1 is the nearest flat mesh, which links of earlier versions mean by it. */
function writePlanarising(how: Planarising | null): StepsJson["p"] {
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

export function writeSteps(steps: MarkedSteps): StepsJson {
  const { handles, families, mark } = steps;
  const variation = families.at(-1);
  const earlier = families.slice(0, -1);
  return {
    p: writePlanarising(steps.planarised),
    h: handles.map(({ vertex, target, pinned }) => [vertex, ...target, pinned ? 1 : 0]),
    w: writeSettings(steps.settings),
    x: variation?.coefficients ?? null,
    ...(variation && { d: howFound(variation) }),
    ...(earlier.length > 0 && {
      e: earlier.map((family) => [...howFound(family), ...family.coefficients]),
    }),
    r: [mark.hash, mark.moved, mark.probes],
  };
}

/** null if they are not whole. */
export function readSteps(json: Json): MarkedSteps | null {
  const handles = readHandles(json.h);
  const settings = readSettings(json.w);
  const families = readFamilies(json);
  const mark = readMark(json.r);
  const planarised = readPlanarising(json.p);
  if (!handles || !settings || !families || !mark || planarised === undefined) return null;
  return { planarised, handles, settings, families, mark };
}
