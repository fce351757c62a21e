// SPDX-License-Identifier: MIT
// Where nothing of an edit may go, in the words of the command line: "below=0", "box=0,0,0,1,1,1", "self",
// "mesh=0,0,0;1,0,0;1,1,0/0,1,2".
import type { Extent } from "../mesh/extent.ts";
import { cross, minus } from "../mesh/vector.ts";
import type { Model } from "../solver/protocol.ts";
import type { Point } from "./design.ts";

/** Of the numbers behind it: z; z; a, b, c, d of a·x + b·y + c·z > d; two corners; none. */
const NUMBERS = { below: 1, above: 1, plane: 4, box: 6, self: 0 } as const;

/** One that a person asks for by its numbers. */
export type PlainKind = keyof typeof NUMBERS;
export type KeepOutKind = PlainKind | "mesh";

/** Model units. */
export interface KeepOut {
  readonly kind: KeepOutKind;
  /** Of a model x, y, z of every point. */
  readonly numbers: readonly number[];
  /** Of a model: points of every panel. */
  readonly panels?: readonly (readonly number[])[];
}

const isPlainKind = (word: string): word is PlainKind => Object.hasOwn(NUMBERS, word);

/** The core's own limit. */
const MOST_PANELS = 20_000;

/** "0,0,0;1,0,0;1,1,0/0,1,2"; null if it is no model. */
function readModel(text: string): KeepOut | null {
  const [points = "", list = "", ...more] = text.split("/");
  const triples = points.split(";").map((point) => point.split(",").map(Number));
  const panels = list.split(";").map((panel) => panel.split(",").map(Number));
  const whole = triples.every((p) => p.length === 3 && p.every(Number.isFinite));
  const known = panels.every(
    (panel) => panel.length > 2 && panel.every((v) => triples[v] !== undefined),
  );
  if (!whole || !known || more.length > 0 || panels.length > MOST_PANELS) return null;
  return { kind: "mesh", numbers: triples.flat(), panels };
}

function modelText({ numbers, panels = [] }: KeepOut): string {
  const points = Array.from({ length: numbers.length / 3 }, (_, k) =>
    numbers.slice(3 * k, 3 * k + 3).join(","),
  );
  return `mesh=${points.join(";")}/${panels.map((panel) => panel.join(",")).join(";")}`;
}

/** A model as a keep-out, without the points that no panel has. */
export function keepOutOf({ points, offsets, vertices }: Model): KeepOut {
  const places = new Map<number, number>();
  for (const v of vertices) if (!places.has(v)) places.set(v, places.size);
  const numbers = [...places.keys()].flatMap((v) => [...points.subarray(3 * v, 3 * v + 3)]);
  const panels = Array.from({ length: offsets.length - 1 }, (_, f) =>
    [...vertices.subarray(offsets[f], offsets[f + 1])].map((v) => places.get(v) ?? 0),
  );
  return { kind: "mesh", numbers, panels };
}

/** A model of triangles, three corners each, one after the other: corners at one place are one point, and
 * what then has no three is left out. */
export function keepOutOfTriangles(corners: Float64Array): KeepOut {
  const places = new Map<string, number>();
  const numbers: number[] = [];
  const placeOf = (corner: readonly number[]): number => {
    const key = corner.join();
    const known = places.get(key);
    if (known !== undefined) return known;
    numbers.push(...corner);
    places.set(key, places.size);
    return places.size - 1;
  };
  const panels: number[][] = [];
  for (let k = 0; k < corners.length; k += 9) {
    const panel = [0, 3, 6].map((at) => placeOf([...corners.subarray(k + at, k + at + 3)]));
    if (new Set(panel).size === 3) panels.push(panel);
  }
  return { kind: "mesh", numbers, panels };
}

/** null if it is none. */
export function readKeepOut(text: string): KeepOut | null {
  const [kind = "", list, ...more] = text.split("=");
  if (kind === "mesh") return more.length === 0 ? readModel(list ?? "") : null;
  const numbers = list?.split(",").map((word) => (word === "" ? Number.NaN : Number(word))) ?? [];
  if (!isPlainKind(kind) || more.length > 0 || numbers.length !== NUMBERS[kind]) return null;
  return numbers.every(Number.isFinite) ? { kind, numbers } : null;
}

export function keepOutText(one: KeepOut): string {
  if (one.kind === "mesh") return modelText(one);
  return one.numbers.length > 0 ? `${one.kind}=${one.numbers.join(",")}` : one.kind;
}

/** Why it can be none, in a sentence; null where it can. The core has the same rules. */
export function problemOf({ kind, numbers, panels = [] }: KeepOut): string | null {
  if (kind === "mesh" && (panels.length === 0 || panels.length > MOST_PANELS))
    return `A model needs panels, at most ${MOST_PANELS.toLocaleString("en")}.`;
  const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0] = numbers;
  if (kind === "box" && !(a < d && b < e && c < f))
    return "The first corner must be lower than the second along X, Y and Z.";
  if (kind === "plane" && !(Math.hypot(a, b, c) > 0)) return "The direction needs a length.";
  return null;
}

/** A keep-out moved by a vector. */
export function keepOutMoved(one: KeepOut, by: Point): KeepOut {
  const { kind, numbers } = one;
  const [a = 0, b = 0, c = 0, d = 0] = numbers;
  if (kind === "below" || kind === "above") return { kind, numbers: [a + by[2]] };
  if (kind === "plane") return { kind, numbers: [a, b, c, d + a * by[0] + b * by[1] + c * by[2]] };
  return { ...one, numbers: numbers.map((x, k) => x + (by[(k % 3) as 0 | 1 | 2] ?? 0)) };
}

/** The plane through three points as a, b, c of length 1, upwards where it can be, and d; null where
 * they are in one line. */
function planeThrough([p, q, r]: readonly [Point, Point, Point]): readonly number[] | null {
  const [u, v] = [minus(q, p), minus(r, p)];
  const n = cross(u, v);
  const length = Math.hypot(...n);
  if (!(length > 1e-9 * Math.hypot(...u) * Math.hypot(...v))) return null;
  const up = n.map((x) => x * (n[2] < 0 ? -1 : 1)).map((x) => x / length);
  return [...up, up.reduce((sum, x, k) => sum + x * (p[k] ?? 0), 0)];
}

/** What a new keep-out is put beside. */
export interface Surroundings {
  readonly extent: Extent;
  /** Selected points, the latest last. */
  readonly chosen: readonly Point[];
  /** Model units; numbers are its multiples. */
  readonly step: number;
}

/** A keep-out that a person has just asked for: it touches nothing yet, and is a little work away from right. */
export function firstKeepOut(kind: PlainKind, { extent, chosen, step }: Surroundings): KeepOut {
  const { low, high } = extent;
  const down = (x: number): number => Number((Math.floor(x / step) * step).toPrecision(12));
  const up = (x: number): number => Number((Math.ceil(x / step) * step).toPrecision(12));
  if (kind === "below") return { kind, numbers: [down(low[2])] };
  if (kind === "above") return { kind, numbers: [up(high[2])] };
  if (kind === "self") return { kind, numbers: [] };
  const [p, q, r] = chosen;
  if (kind === "plane") {
    const through = p && q && r && chosen.length === 3 ? planeThrough([p, q, r]) : null;
    return { kind, numbers: through ?? [1, 0, 0, up(high[0])] };
  }
  const middle = chosen.at(-1) ?? [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, high[2]];
  const size = 20 * step;
  const corner = [middle[0] - size / 2, middle[1] - size / 2, middle[2] + size / 2].map(up);
  return { kind, numbers: [...corner, ...corner.map((x) => up(x + size))] };
}
