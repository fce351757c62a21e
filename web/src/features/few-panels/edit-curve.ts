// SPDX-License-Identifier: MIT
// One edit in several ways, from gentle to few panels made again: what each is asked for, and which of
// them are worth choosing.

import type { Design } from "../../design/design.ts";
import { counted } from "../../quantity/counted.ts";
import { foldGrowth } from "../../solver/found-limits.ts";
import type { EditSettings } from "../../solver/protocol.ts";
import { formatDegrees } from "../../state/fold.ts";
import { countHealth } from "../../state/panel-rows.ts";

/** As near to their targets handles have arrived: of the longest way of one, as on the command line. */
export const WITHIN_HANDLE = 0.05;

/** ω_h with which handles arrive, as on the command line. */
const ARRIVING = 100_000;
/** Degrees by which folds may sharpen; the closest limit takes longest. */
const GROWTHS: readonly number[] = [15, 30, 8];
/** The paper's weight ω_s. */
const SPARSITIES: readonly (readonly [number, string])[] = [
  [1, "Sparse"],
  [10, "Sparser"],
];

/** How the edit is asked for. */
export interface Way {
  readonly label: string;
  readonly kind: "edit" | "fewest";
  readonly settings: EditSettings;
  /** Of the fewest: enough of them; 0 for as few as can be. */
  readonly most: number;
}

const isFold = (limit: string): boolean => limit.startsWith("fold=");

function fewestWays(settings: EditSettings): Way[] {
  const fewest = { kind: "fewest", most: 0 } as const;
  if (settings.limits.some(isFold))
    return [{ label: "Fewest within your limit", ...fewest, settings }];
  const within = (degrees: number): Way => ({
    label: `Fewest, folds up to ${degrees}° sharper`,
    ...fewest,
    settings: { ...settings, limits: [...settings.limits, `fold=+${degrees}`] },
  });
  const [first, second, ...closer] = GROWTHS.map(within);
  const any: Way = { label: "Fewest, however sharp the folds", ...fewest, settings };
  return [first, second, any, ...closer].filter((way) => way !== undefined);
}

/** @param stated limits of the design that the page did not find itself
 * @param most panels, for the one way to make so many again; 0 for all ways */
export function waysOf(
  { settings }: Design,
  stated: readonly string[],
  most: number,
): readonly Way[] {
  const limits = settings.limits.filter((limit) => !isFold(limit) || stated.includes(limit));
  const attraction = Math.max(settings.attraction, ARRIVING);
  const arriving = { ...settings, attraction, limits, continuation: 0 };
  if (most > 0)
    return [{ label: `At most ${most} panels`, kind: "fewest", settings: arriving, most }];
  const sparse = SPARSITIES.map(([locality, label]): Way => {
    const weights = { softness: 0, locality, smoothness: 1 };
    return { label, kind: "edit", most: 0, settings: { ...arriving, ...weights } };
  });
  return [...sparse, ...fewestWays(arriving)];
}

/** The edit in one of these ways. */
export interface CurvePoint {
  readonly label: string;
  readonly design: Design;
  /** To be cut again. */
  readonly panels: number;
  /** With any one point more held, the handles do not arrive; null where nobody looked. */
  readonly minimal: boolean | null;
}

export const growthOf = ({ design }: CurvePoint): number => Math.max(0, foldGrowth(design.report));

/** How many panels have a corner that moved, by the core's figures of each: those with a new bevel alone
 * keep their outline. */
export function cutAgain(health: Float32Array): number {
  const { changed, bevel } = countHealth(health);
  return changed - bevel;
}

/** "42 panels cut again, folds up to 8° sharper". */
export function priceWords(panels: number, growth: number): string {
  return `${counted(panels, "panel")} cut again, folds up to ${formatDegrees(growth)} sharper`;
}

export const pointWords = (point: CurvePoint): string => priceWords(point.panels, growthOf(point));

/** The first, as it is, and of the others those than which none has fewer panels and no sharper a fold;
 * from many panels to few. */
export function worthChoosing(points: readonly CurvePoint[]): readonly CurvePoint[] {
  const [first, ...others] = points;
  if (!first) return [];
  let fewest = first.panels;
  const gentle = [...others].sort((a, b) => growthOf(a) - growthOf(b) || a.panels - b.panels);
  const chosen = gentle.filter(({ panels }) => {
    const fewer = panels < fewest;
    fewest = Math.min(fewest, panels);
    return fewer;
  });
  return [first, ...chosen];
}
