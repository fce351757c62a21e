// SPDX-License-Identifier: MIT
// Frozen: what was done to a mesh, as version 1 packed it into links, and into variants of saved designs:
//   p  how its mesh was planarised: 0, 1 (the nearest flat mesh), or the weight of fairness, the
//      boundary and the shape kept, kinds of constraints, how far points go and panels stay out of flat
//   h  handles: vertex, x, y, z, pinned
//   w  settings, by the PLACES of settings.ts
//   x  slider values of the last family; null for none
//   d  directions asked for, whether by stiffness (1) and by weights that follow (2)
//   e  families before that of `x`: what `d` says, then the coefficients
//   r  mark of the result

import type { Planarising, ResultMark } from "../../solver/protocol.ts";
import type { Variant } from "../companions.ts";
import type { Family } from "../design.ts";
import { readKept } from "../kept-kind.ts";
import type { MarkedSteps } from "../marked-steps.ts";
import { NEAREST_FLAT } from "../planarising.ts";
import { isIndex, isName, isNumbers, isRecord, type Json } from "../reading.ts";
import { readHandles, readSettings, readWeights, WEIGHT_COUNT } from "./settings.ts";

/** The solver's own limit. */
const MOST_DIRECTIONS = 24;
/** Vertex, x, y, z for each recorded point. */
const MOST_PROBES = 4 * 64;
const MOST_FAMILIES = 100;

const BY_STIFFNESS = 1;
const BY_WEIGHTS = 2;

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

/** A variant beside a design: what was done, and a name (n). */
export function readVariant(value: unknown): Variant | null {
  const steps = isRecord(value) ? readSteps(value) : null;
  return isRecord(value) && isName(value.n) && steps ? { name: value.n, steps } : null;
}
