// SPDX-License-Identifier: MIT
// A design is data: a source, a recipe, and the shape that the recipe gave.
import { usual } from "virtual:core-defaults";
import type {
  DesignVariation,
  EditSettings,
  Planarising,
  Shape,
  ShapeReport,
  Source,
  Targets,
} from "../solver/protocol.ts";
import { SAMPLES } from "./samples.ts";
import { ofAnyMesh } from "./supports.ts";

export type Point = readonly [number, number, number];

export interface HandleRow {
  readonly vertex: number;
  /** Where the point should go, model units. */
  readonly target: Point;
  /** A pinned point keeps its base position; its target is not used. */
  readonly pinned: boolean;
}

/** One member of a family of variations. */
export type Family = DesignVariation;

/** The family alone, of what may say more. */
export const familyOf = ({ coefficients, asked, eigenbasis, weights }: Family): Family => ({
  coefficients,
  asked,
  eigenbasis,
  ...(weights && { weights }),
});

export interface Variation extends Family {
  /** The shape around which the directions were found; the same shape gives the same ones. */
  readonly centre: Shape;
  /** The families before, each around what the one before it gave; the last led to `centre`. */
  readonly earlier: readonly Family[];
  /** Whether the shape has been projected since the sliders last moved. */
  readonly exact: boolean;
}

export interface Design {
  readonly source: Source;
  readonly planarised: Planarising | null;
  readonly handles: readonly HandleRow[];
  readonly settings: EditSettings;
  readonly shape: Shape;
  readonly report: ShapeReport;
  readonly variation: Variation | null;
}

/** The command line's defaults; what a link or a file does not say. */
export const DEFAULT_SETTINGS: EditSettings = {
  ...usual,
  supports: [],
  continuation: 0,
  symmetry: [],
  cuts: [],
};

/** What a new visitor's page starts with, see docs/decisions/0009-reach-and-softness.md. */
export const FIRST_SETTINGS: EditSettings = {
  ...DEFAULT_SETTINGS,
  attraction: 10_000,
  reach: 6,
  keepBoundary: true,
  softness: 5,
};

/** The raw weights, without limits, as on the command line. */
export const RAW_WEIGHTS: Partial<EditSettings> = {
  attraction: DEFAULT_SETTINGS.attraction,
  locality: DEFAULT_SETTINGS.locality,
  smoothness: DEFAULT_SETTINGS.smoothness,
  reach: 0,
  reachLength: 0,
  keepBoundary: false,
  softness: 0,
};

/** Reach and softness in their place. */
export const SOFT_LIMITS: Partial<EditSettings> = {
  attraction: FIRST_SETTINGS.attraction,
  reach: FIRST_SETTINGS.reach,
  reachLength: 0,
  keepBoundary: FIRST_SETTINGS.keepBoundary,
  softness: FIRST_SETTINGS.softness,
};

/**
 * What another mesh starts with: everything that the page has a control for stays as the controls
 * show it, so that nothing changes behind the user's back. What has none goes back to its default:
 * a link or a file may have set it, and nobody could see that it is still there. So do keep-outs, which
 * are somewhere: where another mesh is they mean nothing; and so do symmetry, cuts and bends, which are a mesh's own.
 * A limit on folds that the page itself found goes, too, see freshDesign().
 */
export function settingsForNew(shown: EditSettings): EditSettings {
  const { sparsity, maxIterations, reachLength, continuation } = DEFAULT_SETTINGS;
  const { keepOuts, clearance, symmetry, cuts } = DEFAULT_SETTINGS;
  const { attraction } = shown.softness > 0 ? FIRST_SETTINGS : DEFAULT_SETTINGS;
  const own = { attraction, sparsity, maxIterations, reachLength, continuation };
  const supports = ofAnyMesh(shown.supports);
  const flat = shown.keepBends ? DEFAULT_SETTINGS.tolerance : shown.tolerance;
  const flatness = { tolerance: flat, keepBends: false };
  return { ...shown, ...own, ...flatness, keepOuts, clearance, symmetry, cuts, supports };
}

export const NO_SHAPE: Shape = { moved: new Int32Array(0), positions: new Float64Array(0) };

export const NO_REPORT: ShapeReport = {
  status: "converged",
  movedVertices: 0,
  maxDisplacement: 0,
  worstGap: 0,
  worstMmPerM: 0,
  worstExcess: 0,
  sharpestFold: null,
  handleError: 0,
  objective: 0,
  iterations: 0,
  seconds: 0,
  residuals: [],
  optimality: {},
};

/** Whether an edit of the handles, which starts from the base, would leave a variation behind. */
export const leftBehind = ({ variation }: Design): boolean =>
  variation !== null &&
  (variation.earlier.length > 0 || variation.coefficients.some((x) => x !== 0));

export const sourceName = (source: Source): string =>
  source.kind === "file"
    ? source.name
    : (SAMPLES.find((s) => s.name === source.name)?.label ?? source.name);

export function toTargets(handles: readonly HandleRow[]): Targets {
  return {
    handles: handles.filter((row) => !row.pinned).flatMap((row) => [row.vertex, ...row.target]),
    pins: handles.filter((row) => row.pinned).map((row) => row.vertex),
  };
}

/** A link writes −0 as 0, so that a target never is −0. */
const plain = ([x, y, z]: Point): Point => [x + 0, y + 0, z + 0];

/** Targets as the solver took them: vertex, x, y, z for each that is not pinned. */
export function withTaken(rows: readonly HandleRow[], taken: readonly number[]): HandleRow[] {
  let k = -1;
  return rows.map((row) => {
    if (row.pinned) return row;
    k += 1;
    const [x = 0, y = 0, z = 0] = taken.slice(4 * k + 1, 4 * k + 4);
    return { ...row, target: plain([x, y, z]) };
  });
}

export function withHandle(rows: readonly HandleRow[], given: HandleRow): HandleRow[] {
  const row = { ...given, target: plain(given.target) };
  return rows.some((r) => r.vertex === row.vertex)
    ? rows.map((r) => (r.vertex === row.vertex ? row : r))
    : [...rows, row];
}

export const withoutHandle = (rows: readonly HandleRow[], vertex: number): HandleRow[] =>
  rows.filter((row) => row.vertex !== vertex);

/** Whether nothing has been done since the mesh was opened. */
export const isAsOpened = ({ planarised, handles, shape }: Design): boolean =>
  planarised === null && handles.length === 0 && shape.moved.length === 0;
