// SPDX-License-Identifier: MIT
// A design as the JSON of docs/formats.md, which the command line and GLB files hold too. What can
// be wrong with it is said in one sentence that names the field.
import type { BoundarySupport, EditSettings, Planarising, Source } from "../solver/protocol.ts";
import { DEFAULT_SETTINGS, type Family, type HandleRow } from "../state/design.ts";
import type { Parsed } from "../state/expression.ts";
import { kindOf, kindTolerance, readKept } from "../state/kept-kind.ts";
import { isNearestFlat, NEAREST_FLAT } from "../state/planarising.ts";
import type { Recipe, ResultMark, Steps } from "../state/recipe.ts";
import { readLimits } from "../state/stated-limit.ts";
import { isUnit } from "../state/units.ts";
import { crc32 } from "./crc32.ts";
import { type BaseMesh, meshHash } from "./mesh-hash.ts";
import {
  ENGINES,
  FAIRNESS,
  isIndex,
  isName,
  isNumber,
  isNumbers,
  isRecord,
  type Json,
  MOST_DIRECTIONS,
  readFormat,
  SPARSITY,
} from "./reading.ts";

/** What is read: a recipe, and what its source says. */
export interface DesignText extends Omit<Steps, "source" | "camera"> {
  /** null if the mesh lies beside the design. */
  readonly source: Source | null;
  /** The name of the mesh's file; "" for a sample. */
  readonly meshName: string;
}

class Refused extends Error {}

const hex = (hash: number): string => hash.toString(16).padStart(8, "0");

function sourceJson(source: Source, base: BaseMesh): Json {
  return source.kind === "sample"
    ? { sample: source.name, size: source.size }
    : { file: source.name, hash: hex(meshHash(base)) };
}

/** The supports that this page has a control for, by the words of the command line. */
const SUPPORTS: readonly (readonly [BoundarySupport, string])[] = [
  ["level", "level=z:boundary"],
  ["outline", "outline:boundary"],
];

const supportsJson = ({ boundarySupport }: EditSettings): Json => {
  const words = SUPPORTS.flatMap(([support, text]) => (support === boundarySupport ? [text] : []));
  return words.length > 0 ? { supports: words } : {};
};

const continuationJson = ({ continuation }: EditSettings): Json =>
  continuation > 0 ? { continuation } : {};

const constraintJson = (kept: string): Json => ({
  kind: kindOf(kept),
  tolerance: kindTolerance(kept),
});

function optionsJson(settings: EditSettings): Json {
  const { hardHandles, keepShape, engine, maxIterations, ...others } = settings;
  const { reach, reachLength, keepBoundary, boundarySupport: _, ...limited } = others;
  const { softness, limits, constraints, continuation: __, ...rest } = limited;
  return {
    ...rest,
    hard: hardHandles,
    solver: engine,
    max_iterations: maxIterations,
    ...(keepShape && { shape: true }), // absent in designs from before the bounds
    // Added later: where they are as usual, older readers need not know them.
    ...(reach !== 0 && { reach }),
    ...(reachLength !== 0 && { reach_length: reachLength }),
    ...(keepBoundary && { keep_boundary: true }),
    ...(softness !== 0 && { softness }),
    ...(constraints.length > 0 && { constraints: constraints.map(constraintJson) }),
    ...(limits.length > 0 && { bounds: limits }),
  };
}

/** `true` is the nearest flat mesh, as designs of earlier versions say it. */
function planarisedJson(how: Planarising | null): Json | boolean {
  if (!how) return false;
  if (isNearestFlat(how)) return true;
  const { smooth, keepBoundary, keepShape, constraints } = how;
  return {
    smooth,
    keep_boundary: keepBoundary,
    shape: keepShape,
    ...(constraints.length > 0 && { constraints: constraints.map(constraintJson) }),
  };
}

const variationJson = ({ coefficients, asked, eigenbasis }: Family): Json => ({
  dimension: asked,
  eigen: eigenbasis,
  ...FAMILY,
  coefficients,
  exact: true,
});

/** The core's SubspaceOptions that the page leaves alone. */
const FAMILY = {
  fairness_weight: 3,
  sparsity_weight: 1,
  closeness_weight: 0,
  correlation: 0.95,
  reach: 2,
} as const;

function markJson({ hash, moved, probes }: ResultMark): Json {
  const rows: number[][] = [];
  for (let p = 0; p + 3 < probes.length; p += 4) rows.push(probes.slice(p, p + 4));
  return { hash: hex(hash), moved, probes: rows };
}

/** The bytes of a design's mesh, to ride along. */
function bytesJson(source: Source, bytes: Uint8Array | null): Json {
  if (source.kind === "sample" || !bytes) return {};
  return { format: source.format, bytes: toBase64(bytes) };
}

/** The text for a GLB, which holds the base itself, or with the bytes of the mesh for a file alone. */
export function writeDesign(
  recipe: Recipe,
  base: BaseMesh,
  bytes: Uint8Array | null = null,
): string {
  const { handles, families } = recipe;
  return JSON.stringify({
    format: "planish-design",
    version: 1,
    source: { ...sourceJson(recipe.source, base), ...bytesJson(recipe.source, bytes) },
    planarised: planarisedJson(recipe.planarised),
    unit: recipe.unit,
    handles: handles.filter((row) => !row.pinned).map((row) => [row.vertex, ...row.target]),
    pins: handles.filter((row) => row.pinned).map((row) => row.vertex),
    ...supportsJson(recipe.settings),
    ...continuationJson(recipe.settings),
    options: optionsJson(recipe.settings),
    variations: families.map(variationJson),
    result: markJson(recipe.mark),
  });
}

function check(holds: boolean, sentence: string): asserts holds {
  if (!holds) throw new Refused(sentence);
}

const brief = (value: unknown): string => (JSON.stringify(value) ?? "none").slice(0, 20);

function readObject(value: unknown, path: string, known: readonly string[]): Json {
  check(isRecord(value), `${path} must be an object.`);
  const stranger = Object.keys(value).find((key) => !known.includes(key));
  check(stranger === undefined, `${path}.${stranger?.slice(0, 40)} is not a field of a design.`);
  return value;
}

type ReadSource = Pick<DesignText, "source" | "meshName"> & { readonly baseHash: number | null };

function readHash(value: unknown, path: string): number {
  const right = typeof value === "string" && /^[0-9a-f]{8}$/.test(value);
  check(right, `${path} must be 8 hexadecimal digits.`);
  return Number.parseInt(value, 16);
}

/** A sample, or a file whose bytes are there or lie beside the design. */
function readSource(value: unknown): ReadSource {
  check(isRecord(value), "source must be an object.");
  if (value.sample !== undefined) {
    const { sample, size } = readObject(value, "source", ["sample", "size"]);
    check(isName(sample) && isIndex(size), "source must name a sample and its size.");
    return { source: { kind: "sample", name: sample, size }, meshName: "", baseHash: null };
  }
  const file = readObject(value, "source", ["file", "hash", "format", "bytes"]);
  check(isName(file.file), "source must name a sample or a file.");
  const name = file.file;
  const baseHash = file.hash === undefined ? null : readHash(file.hash, "source.hash");
  if (file.bytes === undefined) return { source: null, meshName: name, baseHash };
  const format = readFormat(file.format);
  check(format !== null, "source.format must be obj, off, ply or glb.");
  const bytes = typeof file.bytes === "string" ? fromBase64(file.bytes) : null;
  check(bytes !== null && bytes.length > 0, "source.bytes must be base64.");
  const kept = new Blob([bytes as BlobPart]);
  const source = { kind: "file", name, format, bytes: kept, crc: crc32(bytes) } as const;
  return { source, meshName: name, baseHash };
}

/** In pieces: a call takes only so many arguments. */
function toBase64(bytes: Uint8Array): string {
  let letters = "";
  for (let k = 0; k < bytes.length; k += 8192)
    letters += String.fromCharCode(...bytes.subarray(k, k + 8192));
  return btoa(letters);
}

function fromBase64(text: string): Uint8Array | null {
  try {
    return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  } catch {
    return null;
  }
}

function pick<T>(value: unknown, words: readonly T[], usual: T, path: string): T {
  if (value === undefined) return usual;
  const word = words.find((known) => known === value);
  check(word !== undefined, `${path} must be ${words.join(" or ")}.`);
  return word;
}

function readConstraints(value: unknown, where: string): readonly string[] {
  check(Array.isArray(value), `${where} must be a list.`);
  const texts = value.map((one: unknown, k) => {
    const { kind, tolerance } = readObject(one, `${where}[${k}]`, ["kind", "tolerance"]);
    return `${kind}:${tolerance}`;
  });
  const kept = readKept(texts);
  const words = `${where}: this page knows the kinds circular and conical, each once`;
  check(kept !== null, `${words}, with a tolerance above 0.`);
  return kept;
}

function readOptions(value: unknown): Omit<EditSettings, "boundarySupport" | "continuation"> {
  const names = ["attraction", "locality", "smoothness", "fairness", "sparsity"];
  names.push("hard", "solver", "tolerance", "max_iterations", "shape");
  names.push("reach", "reach_length", "keep_boundary", "softness", "constraints", "bounds");
  const options = readObject(value ?? {}, "options", names);
  const constraints = readConstraints(options.constraints ?? [], "options.constraints");
  const limits = readLimits(options.bounds ?? []);
  check(
    limits !== null,
    "options.bounds: this page knows fold=MAX, fold=+MAX, angle=MIN:MAX, edge=MIN:MAX, area=MAX and sheet=WxH, each once; “planish replay” knows all.",
  );
  const usual = DEFAULT_SETTINGS;
  const number = (key: string, otherwise: number): number => {
    const given = options[key] ?? otherwise;
    check(isNumber(given) && given >= 0, `options.${key} must be a number of at least 0.`);
    return given;
  };
  return {
    attraction: number("attraction", usual.attraction),
    locality: number("locality", usual.locality),
    smoothness: number("smoothness", usual.smoothness),
    fairness: pick(options.fairness, FAIRNESS, usual.fairness, "options.fairness"),
    engine: pick(options.solver, ENGINES, usual.engine, "options.solver"),
    sparsity: pick(options.sparsity, SPARSITY, usual.sparsity, "options.sparsity"),
    hardHandles: pick(options.hard, [true, false], usual.hardHandles, "options.hard"),
    keepShape: pick(options.shape, [true, false], false, "options.shape"),
    tolerance: number("tolerance", usual.tolerance),
    maxIterations: number("max_iterations", usual.maxIterations),
    reach: number("reach", usual.reach),
    reachLength: number("reach_length", usual.reachLength),
    keepBoundary: pick(
      options.keep_boundary,
      [true, false],
      usual.keepBoundary,
      "options.keep_boundary",
    ),
    softness: number("softness", usual.softness),
    limits,
    constraints,
  };
}

/** The command line's limits. */
const MOST = { handles: 100_000, pins: 10_000_000, variations: 32, probes: 64 } as const;

function readHandles(handles: unknown, pins: unknown): HandleRow[] {
  check(Array.isArray(handles), "handles must be a list.");
  check(handles.length <= MOST.handles, `handles must be at most ${MOST.handles}.`);
  check(Array.isArray(pins) && pins.every(isIndex), "pins must be a list of points.");
  check(pins.length <= MOST.pins, `pins must be at most ${MOST.pins}.`);
  const rows = handles.map((row: unknown, k): HandleRow => {
    check(isNumbers(row, 4) && isIndex(row[0]), `handles[${k}] must be [point, x, y, z].`);
    const [vertex = 0, x = 0, y = 0, z = 0] = row;
    return { vertex, target: [x, y, z], pinned: false };
  });
  const pinned = pins.map((vertex): HandleRow => ({ vertex, target: [0, 0, 0], pinned: true }));
  return [...rows, ...pinned];
}

function readVariation(value: unknown, k: number): Family {
  const path = `variations[${k}]`;
  const names = ["dimension", "eigen", "coefficients", "exact", ...Object.keys(FAMILY)];
  const given = readObject(value, path, names);
  for (const [key, usual] of Object.entries(FAMILY)) {
    const same = (given[key] ?? usual) === usual;
    check(same, `${path}.${key} is one that only the command line can use.`);
  }
  const { dimension, coefficients, exact = true } = given;
  const enough = isIndex(dimension) && dimension <= MOST_DIRECTIONS;
  check(enough, `${path}.dimension must be a small whole number.`);
  const fits = isNumbers(coefficients) && coefficients.length <= dimension;
  check(fits, `${path}.coefficients must be numbers, at most as many as dimension.`);
  check(exact === true, `${path} is not exact; the page shows exact designs only.`);
  const eigenbasis = pick(given.eigen, [true, false], false, `${path}.eigen`);
  return { coefficients, asked: dimension, eigenbasis };
}

function readMark(value: unknown): ResultMark | null {
  if (value === undefined) return null;
  const { hash, moved, probes } = readObject(value, "result", ["hash", "moved", "probes"]);
  const digits = readHash(hash, "result.hash");
  check(isIndex(moved), "result.moved must be a whole number.");
  const rows = Array.isArray(probes) && probes.every((row) => isNumbers(row, 4));
  check(rows, "result.probes must be a list of [point, x, y, z].");
  check(probes.length <= MOST.probes, `result.probes must be at most ${MOST.probes}.`);
  return { hash: digits, moved, probes: (probes as number[][]).flat() };
}

function readPlanarised(value: unknown): Planarising | null {
  if (!isRecord(value)) return value === true ? NEAREST_FLAT : null;
  const names = ["smooth", "keep_boundary", "shape", "constraints"];
  const { smooth = 0, keep_boundary, shape, constraints } = readObject(value, "planarised", names);
  const isWeight = typeof smooth === "number" && smooth >= 0;
  check(isWeight, "planarised: smooth must be a number of at least 0.");
  return {
    smooth,
    keepBoundary: keep_boundary === true,
    keepShape: shape === true,
    constraints: readConstraints(constraints ?? [], "planarised.constraints"),
  };
}

function readSupports(value: unknown): BoundarySupport {
  const given = value ?? [];
  check(Array.isArray(given), "supports must be a list.");
  if (given.length === 0) return "none";
  const known = SUPPORTS.find(([, text]) => given.length === 1 && given[0] === text);
  const words = SUPPORTS.map(([, text]) => text).join(" or ");
  check(known !== undefined, `supports: this page knows ${words}; “planish replay” knows all.`);
  return known[0];
}

/** The core's kMostContinuation. */
const MOST_STEPS = 1000;

function readContinuation(value: unknown): number {
  const steps = value ?? 0;
  const fits = isIndex(steps) && steps <= MOST_STEPS;
  check(fits, "continuation must be 0 (at once) or from 1 to 1000 steps.");
  return steps;
}

const FIELDS =
  "format version title source planarised unit handles pins supports continuation options variations result";

function readRoot(value: unknown): DesignText {
  const marked = isRecord(value) && value.format === "planish-design";
  check(marked, "This is not a design: format must be planish-design.");
  const root = readObject(value, "The design", FIELDS.split(" "));
  check(
    root.version === 1,
    `The design is of version ${brief(root.version)}; this reads version 1.`,
  );
  const unit = root.unit ?? "m";
  check(typeof unit === "string" && isUnit(unit), "unit must be mm, cm, m, km, in or ft.");
  const variations = root.variations ?? [];
  check(Array.isArray(variations), "variations must be a list.");
  check(variations.length <= MOST.variations, `variations must be at most ${MOST.variations}.`);
  const options = readOptions(root.options);
  check(
    variations.length === 0 || options.limits.length === 0,
    "variations: they keep no stated limits yet; leave options.bounds out.",
  );
  return {
    ...readSource(root.source),
    planarised: readPlanarised(root.planarised),
    unit,
    handles: readHandles(root.handles ?? [], root.pins ?? []),
    settings: {
      ...options,
      boundarySupport: readSupports(root.supports),
      continuation: readContinuation(root.continuation),
    },
    families: variations.map(readVariation),
    mark: readMark(root.result),
    someSliders: true,
  };
}

/** Any text gives a design or one sentence; it never throws. */
export function readDesign(text: string): Parsed<DesignText> {
  try {
    return { ok: true, value: readRoot(JSON.parse(text)) };
  } catch (error) {
    const reason = error instanceof Refused ? error.message : "The design is not JSON.";
    return { ok: false, reason };
  }
}
