// SPDX-License-Identifier: MIT
// What a stranger's JSON may say. Every reader gives a value of the right kind or null.
import { words as WORDS } from "virtual:core-defaults";
import type {
  BoundarySupport,
  EditSettings,
  FileFormat,
  VariationWeights,
} from "../solver/protocol.ts";
import type { Camera } from "../state/camera.ts";
import { DEFAULT_SETTINGS, type Family, type HandleRow } from "../state/design.ts";
import { readKept } from "../state/kept-kind.ts";
import { readLimits } from "../state/stated-limit.ts";

const FORMATS: readonly FileFormat[] = ["obj", "off", "ply", "glb"];

/** The solver's own limit. */
export const MOST_DIRECTIONS = 24;
export const LONGEST_NAME = 1_000;

export type Json = Readonly<Record<string, unknown>>;

export const isRecord = (value: unknown): value is Json =>
  typeof value === "object" && value !== null && !Array.isArray(value);

export const isNumber = (value: unknown): value is number =>
  typeof value === "number" && Number.isFinite(value);

export const isNumbers = (value: unknown, length?: number): value is number[] =>
  Array.isArray(value) &&
  (length === undefined || value.length === length) &&
  value.every((x) => isNumber(x));

export const isIndex = (value: unknown): value is number =>
  Number.isInteger(value) && (value as number) >= 0 && (value as number) < 2 ** 32;

export const isName = (value: unknown): value is string =>
  typeof value === "string" && value.length <= LONGEST_NAME;

export const readFormat = (value: unknown): FileFormat | null =>
  FORMATS.find((format) => format === value) ?? null;

function readHandle(value: unknown): HandleRow | null {
  if (!isNumbers(value, 5)) return null;
  const [vertex, x = 0, y = 0, z = 0, pinned] = value;
  return isIndex(vertex) ? { vertex, target: [x, y, z], pinned: pinned === 1 } : null;
}

/** Rows of vertex, x, y, z, pinned (0 or 1). */
export function readHandles(value: unknown): HandleRow[] | null {
  if (!Array.isArray(value)) return null;
  const rows: HandleRow[] = [];
  for (const item of value) {
    const row = readHandle(item);
    if (!row) return null;
    rows.push(row);
  }
  return rows;
}

/** Where a link and a saved record have each weight of variations: a place is never given away. */
const WEIGHTS = ["fairness", "sparsity", "closeness", "correlation", "spread", "family"] as const;
export const WEIGHT_COUNT = WEIGHTS.length;

export const writeWeights = (weights: VariationWeights): number[] => WEIGHTS.map((w) => weights[w]);

/** Nothing where a family says nothing of them; null: not weights. */
export function readWeights(value: unknown): Pick<Family, "weights"> | null {
  if (value === undefined) return {};
  if (!isNumbers(value, WEIGHT_COUNT) || value.some((x) => x < 0)) return null;
  const [fairness = 0, sparsity = 0, closeness = 0, correlation = 0, spread, family] = value;
  if (!isIndex(spread) || !isIndex(family)) return null;
  return { weights: { fairness, sparsity, closeness, correlation, spread, family } };
}

/**
 * Where a link and a saved record have each setting: a place is never given to another one. Later
 * versions of the page added places at the end, and leave out those at the end that are as usual.
 */
const PLACES = [
  ...(["attraction", "locality", "smoothness", "fairness", "engine"] as const),
  ...(["sparsity", "hardHandles", "tolerance", "maxIterations"] as const),
  ...(["reach", "reachLength", "keepBoundary", "softness"] as const),
  "continuation",
] as const;
type Place = (typeof PLACES)[number];
/** How many places there are in what some version of the page wrote; this one writes no 6. */
const READ_LENGTHS = [5, 6, 9, 13, 14];
const WRITTEN_LENGTHS = [5, 9, 13, 14];

/** Behind whether the boundary is kept, which is the number's first bit. */
const BOUNDARY_SUPPORTS: readonly BoundarySupport[] = ["none", "level", "outline"];

function pack(settings: EditSettings, place: Place): number | string {
  if (place === "keepBoundary") {
    const { keepBoundary, boundarySupport } = settings;
    return Number(keepBoundary) + 2 * BOUNDARY_SUPPORTS.indexOf(boundarySupport);
  }
  const value = settings[place];
  return typeof value === "boolean" ? Number(value) : value;
}

/** What `given` in `place` says; null if it says nothing. The core's table knows types and words. */
function unpack(place: Place, given: unknown): Partial<EditSettings> | null {
  const usual = DEFAULT_SETTINGS[place];
  if (typeof usual === "string") {
    const words: readonly string[] = WORDS[place as keyof typeof WORDS];
    return words.some((word) => word === given) ? { [place]: given } : null;
  }
  if (!isNumber(given)) return null;
  if (place === "keepBoundary")
    return {
      keepBoundary: given % 2 === 1,
      boundarySupport: BOUNDARY_SUPPORTS[given >> 1] ?? "none",
    };
  return { [place]: typeof usual === "boolean" ? given === 1 : given };
}

/** Last of the settings but the lists where panels keep their shape; absent in designs from before that bound. */
const SHAPE = "shape";

const isKind = (one: unknown): boolean => typeof one === "string" && !one.includes("=");

/** By PLACES; then "shape"; then a list of stated limits and kept kinds, which have no "=". */
export function readSettings(value: unknown): EditSettings | null {
  if (!Array.isArray(value)) return null;
  const rest: unknown[] = [...value];
  const listed: unknown[] = Array.isArray(rest.at(-1)) ? (rest.pop() as unknown[]) : [];
  const keepShape = rest.at(-1) === SHAPE;
  if (keepShape) rest.pop();
  const limits = readLimits(listed.filter((one) => !isKind(one)));
  const constraints = readKept(listed.filter(isKind));
  if (!limits || !constraints || !READ_LENGTHS.includes(rest.length)) return null;
  let settings: EditSettings = { ...DEFAULT_SETTINGS, keepShape, limits, constraints };
  for (const [k, given] of rest.entries()) {
    const place = PLACES[k];
    const said = place && unpack(place, given);
    if (!said) return null;
    settings = { ...settings, ...said };
  }
  return settings;
}

export function writeSettings(settings: EditSettings): unknown[] {
  const packed = PLACES.map((place) => pack(settings, place));
  const different = PLACES.findLastIndex((place, k) => packed[k] !== pack(DEFAULT_SETTINGS, place));
  const length = WRITTEN_LENGTHS.find((places) => places > different);
  const whole = [...packed.slice(0, length), ...(settings.keepShape ? [SHAPE] : [])];
  const listed = [...settings.limits, ...settings.constraints];
  return listed.length > 0 ? [...whole, listed] : whole;
}

/** Position and target; undefined if there is something else than a camera or nothing. */
export function readCamera(value: unknown): Camera | null | undefined {
  if (value === undefined || value === null) return null;
  if (!isNumbers(value, 6)) return undefined;
  const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0] = value;
  return { position: [a, b, c], target: [d, e, f] };
}

export const writeCamera = ({ position, target }: Camera): number[] =>
  [...position, ...target].map((x) => Number(x.toFixed(3)));
