// SPDX-License-Identifier: MIT
// What a stranger's JSON may say. Every reader gives a value of the right kind or null.
import type {
  BoundarySupport,
  EditSettings,
  EngineName,
  Fairness,
  FileFormat,
  Sparsity,
} from "../solver/protocol.ts";
import type { Camera } from "../state/camera.ts";
import { DEFAULT_SETTINGS, type HandleRow } from "../state/design.ts";
import { readKept } from "../state/kept-kind.ts";
import { readLimits } from "../state/stated-limit.ts";

const FORMATS: readonly FileFormat[] = ["obj", "off", "ply", "glb"];
export const FAIRNESS: readonly Fairness[] = ["laplacian", "second", "third"];
export const ENGINES: readonly EngineName[] = ["newton", "alm"];
export const SPARSITY: readonly Sparsity[] = ["l21", "l2", "none"];

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

type Rest = Omit<
  EditSettings,
  | "attraction"
  | "locality"
  | "smoothness"
  | "fairness"
  | "engine"
  | "keepShape"
  | "limits"
  | "constraints"
>;

/** Behind whether the boundary is kept, which is the number's first bit. */
const BOUNDARY_SUPPORTS: readonly BoundarySupport[] = ["none", "level", "outline"];

/** How many numbers follow the sparsity: the first rest, with the limits, with the continuation. */
const [FIRST_REST, LIMITED_REST, LONGEST_REST] = [3, 7, 8];

/** What was added to the settings later: absent where it is all as usual. */
function readRest(value: readonly unknown[]): Rest | null {
  const { attraction, locality, smoothness, fairness, engine, ...others } = DEFAULT_SETTINGS;
  const { keepShape, limits, constraints, ...usual } = others;
  if (value.length === 0) return usual;
  const named = SPARSITY.find((name) => name === value[0]);
  if (named && value.length === 1) return { ...usual, sparsity: named };
  const numbers: unknown = value.slice(1);
  const counted = [FIRST_REST, LIMITED_REST, LONGEST_REST].some((n) => isNumbers(numbers, n));
  if (!named || !counted || !isNumbers(numbers)) return null;
  const [hard, given = 0, most = 0, ...later] = numbers;
  const [rings = 0, length = 0, keep = 0, softness = 0, continuation = 0] = later;
  return {
    sparsity: named,
    hardHandles: hard === 1,
    tolerance: given,
    maxIterations: most,
    reach: rings,
    reachLength: length,
    keepBoundary: keep % 2 === 1,
    boundarySupport: BOUNDARY_SUPPORTS[keep >> 1] ?? "none",
    softness,
    continuation,
  };
}

/** Last of the settings but the limits where panels keep their shape; absent in designs from before that bound. */
const SHAPE = "shape";

/**
 * Attraction, locality, smoothness, fairness, engine; then sparsity; then hard, tolerance, limit;
 * then reach, its length, keep boundary, softness; then the continuation, if any; then "shape"; then
 * a list of stated limits and kept kinds, which have no "=".
 */
export function readSettings(value: unknown): EditSettings | null {
  if (!Array.isArray(value)) return null;
  const limited = Array.isArray(value.at(-1));
  const listed: unknown[] = limited ? value.at(-1) : [];
  const isKind = (one: unknown): boolean => typeof one === "string" && !one.includes("=");
  const limits = readLimits(listed.filter((one) => !isKind(one)));
  const constraints = readKept(listed.filter(isKind));
  const others: unknown[] = limited ? value.slice(0, -1) : value;
  const keepShape = others.at(-1) === SHAPE;
  const weightsAndRest = readWeightsAndRest(keepShape ? others.slice(0, -1) : others);
  if (!weightsAndRest || !limits || !constraints) return null;
  return { ...weightsAndRest, keepShape, limits, constraints };
}

type WeightsAndRest = Omit<EditSettings, "keepShape" | "limits" | "constraints">;

function readWeightsAndRest(value: readonly unknown[]): WeightsAndRest | null {
  if (value.length < 5) return null;
  const weights: unknown = value.slice(0, 3);
  const fairness = FAIRNESS.find((name) => name === value[3]);
  const engine = ENGINES.find((name) => name === value[4]);
  const rest = readRest(value.slice(5));
  if (!isNumbers(weights, 3) || !fairness || !engine || !rest) return null;
  const [attraction = 0, locality = 0, smoothness = 0] = weights;
  return { attraction, locality, smoothness, fairness, engine, ...rest };
}

const writeRest = ({ sparsity, hardHandles, tolerance, maxIterations }: EditSettings) => [
  sparsity,
  hardHandles ? 1 : 0,
  tolerance,
  maxIterations,
];

export function writeSettings(settings: EditSettings): unknown[] {
  const { attraction, locality, smoothness, fairness, engine } = settings;
  const { reach, reachLength, keepBoundary, boundarySupport, softness } = settings;
  const boundary = (keepBoundary ? 1 : 0) + 2 * BOUNDARY_SUPPORTS.indexOf(boundarySupport);
  const first = [attraction, locality, smoothness, fairness, engine];
  const rest = writeRest(settings);
  const path = settings.continuation;
  const limits = [reach, reachLength, boundary, softness, ...(path > 0 ? [path] : [])];
  const limited = limits.some((number) => number !== 0);
  const usual = String(rest) === String(writeRest(DEFAULT_SETTINGS));
  const named = limited ? [...first, ...rest, ...limits] : usual ? first : [...first, ...rest];
  const whole = settings.keepShape ? [...named, SHAPE] : named;
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
