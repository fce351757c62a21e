// SPDX-License-Identifier: MIT
// A design as the fragment of a link: "#v1=" and base64url of deflated bytes, which are
//   CRC-32 of the rest (4 bytes) | length of the JSON (4 bytes) | JSON | the file, if any
// little-endian. Links are kept readable for ever: a change of layout is a new version.
import type { EngineName, Fairness, FileFormat, Source } from "../solver/protocol.ts";
import type { HandleRow } from "../state/design.ts";
import type { Parsed } from "../state/expression.ts";
import { crc32, type Recipe } from "../state/recipe.ts";
import { isUnit } from "../state/units.ts";
import { fromBase64Url, toBase64Url } from "./base64url.ts";
import { deflate, inflate } from "./deflate.ts";

const PREFIX = "#v1=";
const HEADER = 8;

const FORMATS: readonly FileFormat[] = ["obj", "off", "ply", "glb"];
const FAIRNESS: readonly Fairness[] = ["laplacian", "second", "third"];
const ENGINES: readonly EngineName[] = ["newton", "alm"];

/** The JSON of version 1. Short names: they are part of every link. */
interface Payload {
  /** Sample name and size, or file name and format. */
  s: [string, number] | [string, FileFormat];
  p: 0 | 1;
  h: [number, number, number, number, 0 | 1][];
  w: [number, number, number, Fairness, EngineName];
  x: readonly number[] | null;
  u: string;
  r: [number, number, readonly number[]];
}

function toPayload({
  source,
  planarised,
  handles,
  settings,
  variation,
  unit,
  mark,
}: Recipe): Payload {
  const { attraction, locality, smoothness, fairness, engine } = settings;
  return {
    s: source.kind === "sample" ? [source.name, source.size] : [source.name, source.format],
    p: planarised ? 1 : 0,
    h: handles.map(({ vertex, target, pinned }) => [vertex, ...target, pinned ? 1 : 0]),
    w: [attraction, locality, smoothness, fairness, engine],
    x: variation,
    u: unit,
    r: [mark.hash, mark.moved, mark.probes],
  };
}

/** The fragment for `recipe`, "#" included. */
export async function encodeLink(recipe: Recipe): Promise<string> {
  const json = new TextEncoder().encode(JSON.stringify(toPayload(recipe)));
  const file = recipe.source.kind === "file" ? recipe.source.bytes : new Uint8Array(0);
  const bytes = new Uint8Array(HEADER + json.length + file.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(4, json.length, true);
  bytes.set(json, HEADER);
  bytes.set(file, HEADER + json.length);
  view.setUint32(0, crc32(bytes.subarray(4)), true);
  return PREFIX + toBase64Url(await deflate(bytes));
}

const refuse = (reason: string): { ok: false; reason: string } => ({ ok: false, reason });
const DAMAGED = refuse(
  "This link is damaged: part of it is missing or was changed. Ask for it again.",
);

const isNumbers = (value: unknown): value is number[] =>
  Array.isArray(value) && value.every((x) => typeof x === "number" && Number.isFinite(x));

const isIndex = (value: unknown): value is number =>
  typeof value === "number" && Number.isInteger(value) && value >= 0;

function readSource(value: unknown, file: Uint8Array): Source | null {
  if (!Array.isArray(value) || value.length !== 2 || typeof value[0] !== "string") return null;
  const [name, second] = value as [string, unknown];
  if (isIndex(second)) return { kind: "sample", name, size: second };
  const format = FORMATS.find((f) => f === second);
  return format ? { kind: "file", name, format, bytes: file } : null;
}

function readHandle(value: unknown): HandleRow | null {
  if (!isNumbers(value) || value.length !== 5) return null;
  const [vertex = 0, x = 0, y = 0, z = 0, pinned = 0] = value;
  return isIndex(vertex) ? { vertex, target: [x, y, z], pinned: pinned === 1 } : null;
}

function readPayload(
  payload: Partial<Record<keyof Payload, unknown>>,
  file: Uint8Array,
): Recipe | null {
  const source = readSource(payload.s, file);
  const handles = Array.isArray(payload.h) ? payload.h.map(readHandle) : [null];
  const [attraction, locality, smoothness, f, e] = Array.isArray(payload.w) ? payload.w : [];
  const weights = [attraction, locality, smoothness];
  const fairness = FAIRNESS.find((name) => name === f);
  const engine = ENGINES.find((name) => name === e);
  const [hash, moved, probes] = Array.isArray(payload.r) ? payload.r : [];
  const { u: unit, x: variation } = payload;
  if (!source || handles.some((row) => row === null) || !isNumbers(weights)) return null;
  if (!fairness || !engine || typeof unit !== "string" || !isUnit(unit)) return null;
  if (!isIndex(hash) || !isIndex(moved) || !isNumbers(probes)) return null;
  if (variation !== null && !isNumbers(variation)) return null;
  return {
    source,
    planarised: payload.p === 1,
    handles: handles.filter((row) => row !== null),
    settings: { attraction, locality, smoothness, fairness, engine },
    variation: variation ?? null,
    unit,
    mark: { hash, moved, probes },
  };
}

export const isLink = (hash: string): boolean => /^#v\d+=/.test(hash);

/** Any string gives a recipe or a sentence that says what is wrong with it; it never throws. */
export async function decodeLink(hash: string): Promise<Parsed<Recipe>> {
  const version = /^#v(\d+)=/.exec(hash)?.[1];
  if (version === undefined) return refuse("This is not a link to a design.");
  if (version !== "1") {
    return refuse(
      `This link is of version ${version}; this page reads version 1. Reload the page.`,
    );
  }
  const packed = fromBase64Url(hash.slice(PREFIX.length));
  const bytes = packed && (await inflate(packed).catch(() => null));
  if (!bytes || bytes.length < HEADER) return DAMAGED;
  const view = new DataView(bytes.buffer);
  const end = HEADER + view.getUint32(4, true);
  if (view.getUint32(0, true) !== crc32(bytes.subarray(4)) || end > bytes.length) return DAMAGED;
  try {
    const payload: unknown = JSON.parse(new TextDecoder().decode(bytes.subarray(HEADER, end)));
    const recipe =
      typeof payload === "object" && payload !== null
        ? readPayload(payload, bytes.slice(end))
        : null;
    return recipe ? { ok: true, value: recipe } : DAMAGED;
  } catch {
    return DAMAGED;
  }
}
