// SPDX-License-Identifier: MIT
// Kinds of constraints that an edit keeps beside planarity, each with its tolerance in degrees:
// "circular:1e-9".
import { kinds } from "virtual:core-defaults";
import type { MeshReport } from "../solver/protocol.ts";

export const KINDS = ["circular", "conical"] as const;
export type Kind = (typeof KINDS)[number];

export const isKind = (word: string): word is Kind => KINDS.some((kind) => kind === word);

/** The command line's own, degrees. */
const toleranceOf = (kind: Kind): number => kinds[kind] ?? Number.NaN;

export const kindOf = (kept: string): Kind | undefined =>
  KINDS.find((kind) => kept.startsWith(`${kind}:`));

const kindTolerance = (kept: string): number => Number(kept.slice(kept.indexOf(":") + 1));

const isKept = (value: unknown): value is string =>
  typeof value === "string" && value.length <= 100 && /^[a-z]+:[\d.e+-]+$/.test(value);

/** A stranger's list, each kind at most once; null if it is none. */
export function readKept(value: unknown): readonly string[] | null {
  if (!Array.isArray(value) || !value.every(isKept)) return null;
  const right = value.every((kept) => kindOf(kept) && kindTolerance(kept) > 0);
  return right && new Set(value.map(kindOf)).size === value.length ? value : null;
}

/** The kinds of `kept` and `kind`, in the order of KINDS. */
export function withKind(kept: readonly string[], kind: Kind): readonly string[] {
  return KINDS.flatMap((name) => {
    const same = kept.filter((one) => kindOf(one) === name);
    return same.length === 0 && name === kind ? [`${kind}:${toleranceOf(kind)}`] : same;
  });
}

/** Degrees: where half of the panels or nodes miss a kind by less, the mesh is meant to be so. */
export const MEANT = 0.05;

export const isMeant = (report: MeshReport, kind: Kind): boolean =>
  (report.kinds[kind]?.median ?? Number.POSITIVE_INFINITY) < MEANT;

/** Degrees: less is rounding. */
export const LEAST_DEFECT = 1e-6;

/** Whether an edit can keep it on this mesh. */
export const isKeptBy = (report: MeshReport, kind: Kind): boolean =>
  (report.kinds[kind]?.excess ?? Number.POSITIVE_INFINITY) <= toleranceOf(kind);
