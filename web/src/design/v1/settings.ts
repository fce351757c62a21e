// SPDX-License-Identifier: MIT
// Frozen: the settings, handles and weights of version 1, as links, files and kept designs have them.
import { words as WORDS } from "virtual:core-defaults";
import type { EditSettings } from "../../solver/protocol.ts";
import { DEFAULT_SETTINGS, type Family, type HandleRow } from "../design.ts";
import { readKept } from "../kept-kind.ts";
import { isIndex, isNumber, isNumbers } from "../reading.ts";
import { readLimits } from "../stated-limit.ts";

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

/** Where version 1 has each weight of variations. */
const WEIGHTS = ["fairness", "sparsity", "closeness", "correlation", "spread", "family"] as const;
export const WEIGHT_COUNT = WEIGHTS.length;

/** Nothing where a family says nothing of them; null: not weights. */
export function readWeights(value: unknown): Pick<Family, "weights"> | null {
  if (value === undefined) return {};
  if (!isNumbers(value, WEIGHT_COUNT) || value.some((x) => x < 0)) return null;
  const [fairness = 0, sparsity = 0, closeness = 0, correlation = 0, spread, family] = value;
  if (!isIndex(spread) || !isIndex(family)) return null;
  return { weights: { fairness, sparsity, closeness, correlation, spread, family } };
}

/**
 * Where version 1 has each setting. Pages added places at the end, and left out those at the end that
 * were as usual.
 */
const PLACES = [
  ...(["attraction", "locality", "smoothness", "fairness", "engine"] as const),
  ...(["sparsity", "hardHandles", "tolerance", "maxIterations"] as const),
  ...(["reach", "reachLength", "keepBoundary", "softness"] as const),
  "continuation",
] as const;
type Place = (typeof PLACES)[number];
/** How many places there are in what some page wrote. */
const READ_LENGTHS = [5, 6, 9, 13, 14];

/** The supports that have a number, behind whether the boundary is kept, which is its first bit. */
const NUMBERED = [[], ["level=z:boundary"], ["outline:boundary"]] as const;

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
      supports: NUMBERED[given >> 1] ?? [],
    };
  return { [place]: typeof usual === "boolean" ? given === 1 : given };
}

const NUMBER = String.raw`-?\d+(?:\.\d*)?(?:e[+-]?\d+)?`;
const several = (count: number): string => Array.from({ length: count }, () => NUMBER).join(",");
const MODEL = String.raw`[-+.,;\de]+\/[,;\d]+`;
const FORM = `level=[xyz]|outline|polyline|surface(?:=${MODEL})?|spring=${NUMBER}|plane=${several(4)}|line=${several(6)}`;
const SUPPORT = new RegExp(String.raw`^(?:${FORM}):(?:boundary|all|\d+(?:,\d+)*)$`);

/** Characters: more is no design of anybody's. */
const LONGEST = 1_000_000;

const isSupport = (value: unknown): value is string =>
  typeof value === "string" && value.length <= LONGEST && SUPPORT.test(value);

/** Last of the settings but the lists where panels keep their shape; absent in designs from before that bound. */
const SHAPE = "shape";

const isKind = (one: unknown): boolean => typeof one === "string" && !one.includes("=");

/** A keep-out or the clearance from all of them; the core knows what they say. */
const isKeepOut = (one: unknown): one is string =>
  typeof one === "string" &&
  (/^(self|(below|above|plane|box|clearance)=[-+.,\de]{1,400})$/.test(one) ||
    (one.length <= LONGEST && /^mesh=[-+.,;\de]+\/[,;\d]+$/.test(one)));

const SYMMETRY = "symmetry=";

const isOfSymmetry = (one: unknown): one is string =>
  typeof one === "string" && /^symmetry=(?:[xyz]|axis:[xyz]:\d{1,3})$/.test(one);

const CUT = "cut=";

/** The core knows what they say. */
const isOfCuts = (one: unknown): one is string =>
  typeof one === "string" &&
  one.length <= LONGEST &&
  /^cut=(?:split|strip|corner|refine|trim)=[-+.,:@\w]+$/.test(one);

/** null if they are more than there may be. */
function readKeepOuts(
  listed: readonly string[],
): Pick<EditSettings, "keepOuts" | "clearance"> | null {
  const keepOuts = listed.filter((one) => !one.startsWith("clearance="));
  const clearances = listed.filter((one) => one.startsWith("clearance="));
  const clearance = Number(clearances[0]?.slice("clearance=".length) ?? 0);
  if (keepOuts.length > 64 || clearances.length > 1 || !(clearance >= 0)) return null;
  return { keepOuts, clearance };
}

/**
 * By PLACES; then "shape"; then a list of stated limits, keep-outs, symmetries, cuts, kept kinds, which
 * have no "=", and supports.
 */
export function readSettings(value: unknown): EditSettings | null {
  if (!Array.isArray(value)) return null;
  const rest: unknown[] = [...value];
  const listed: unknown[] = Array.isArray(rest.at(-1)) ? (rest.pop() as unknown[]) : [];
  const keepShape = rest.at(-1) === SHAPE;
  if (keepShape) rest.pop();
  const supports = listed.filter(isSupport);
  const kept = readKeepOuts(listed.filter(isKeepOut));
  const symmetry = listed.filter(isOfSymmetry).map((one) => one.slice(SYMMETRY.length));
  const cuts = listed.filter(isOfCuts).map((one) => one.slice(CUT.length));
  const known = [isSupport, isKeepOut, isOfSymmetry, isOfCuts];
  const others = listed.filter((one) => !known.some((isKnown) => isKnown(one)));
  const limits = readLimits(others.filter((one) => !isKind(one)));
  const constraints = readKept(others.filter(isKind));
  if (!limits || !constraints || !kept || !READ_LENGTHS.includes(rest.length)) return null;
  let settings: EditSettings = {
    ...DEFAULT_SETTINGS,
    keepShape,
    limits,
    constraints,
    symmetry,
    cuts,
    ...kept,
  };
  for (const [k, given] of rest.entries()) {
    const place = PLACES[k];
    const said = place && unpack(place, given);
    if (!said) return null;
    settings = { ...settings, ...said };
  }
  return supports.length > 0 ? { ...settings, supports } : settings;
}
