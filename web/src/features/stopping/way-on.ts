// SPDX-License-Identifier: MIT
// Where a handle stops on its way to its target, why, and what gets it further.

import type { Design, HandleRow, Point } from "../../design/design.ts";
import { limitHead, limitNumbers } from "../../design/stated-limit.ts";
import { dot, minus } from "../../mesh/vector.ts";
import { formatLength, type Unit } from "../../quantity/units.ts";
import { boundNames } from "../../solver/bounds.ts";
import type { EditSettings } from "../../solver/protocol.ts";
import { formatDegrees } from "../../state/fold.ts";
import { isNoticeable } from "../../state/stopping-short.ts";

/** The handle that is furthest from where it was asked to go; model units. */
export interface Stop {
  readonly vertex: number;
  /** From the base to where it was asked to go. */
  readonly asked: number;
  /** How much of that way it went. */
  readonly got: number;
}

/** By the limit on a drag's folds, by a limit that was stated, that on slides by its own name, by what
 * flat panels can do, by a keep-out, or within limits that no panel is at. */
export type Reason = "fold" | "limits" | "slides" | "panels" | "keep-outs" | "unknown";

/** How a target was gone for: by a drag whose frames were held back short of what an edit may reach, as it was
 * given, or by a search along the way to it. */
export type Sought = "dragged" | "given" | "searched";

export interface WayOn {
  readonly label: string;
  readonly title: string;
  readonly change: Partial<EditSettings>;
  /** Degrees by which folds may grow; null: by any. Infinite: as stated limits let them, no further than those
   * let the handles go. */
  readonly growth: number | null;
}

const MOST_RINGS = 12;
const MORE_RINGS = 3;
const SOFTEST = 10;
const SOFTER = 2;
const MORE_DEGREES = 10;

type PointAt = (vertex: number) => Point;

/** Null where every handle is as good as there. `base` and `at`: points before the edit and after. */
export function stopOf(
  rows: readonly HandleRow[],
  base: PointAt,
  at: PointAt,
  meanEdge: number,
): Stop | null {
  let [worst, most]: [Stop | null, number] = [null, 0];
  for (const { vertex, target } of rows.filter(({ pinned }) => !pinned)) {
    const way = minus(target, base(vertex));
    const went = minus(at(vertex), base(vertex));
    const asked = Math.hypot(...way);
    const short = Math.hypot(...minus(way, went));
    if (short <= most || !isNoticeable(short, asked, meanEdge)) continue;
    const along = dot(way, went) / asked;
    [worst, most] = [{ vertex, asked, got: Math.max(0, along) }, short];
  }
  return worst;
}

/** `held`: a pull of the design was held back; `growth` as in RefusedPull. A limit is named where panels are at it. */
export function reasonOf(
  { report, settings }: Design,
  held: boolean,
  growth: number | null,
): Reason {
  const at = boundNames(report);
  if (at.includes("keep-out")) return "keep-outs";
  if (at.includes("slide")) return "slides";
  const own = held && growth !== null;
  if (own && at.includes("fold")) return "fold";
  const stated = settings.limits.length > 0;
  if (stated && at.length > 0) return "limits";
  const refused = held || report.status === "infeasible_handles";
  return refused && (own || stated) ? "unknown" : "panels";
}

/** "216 of 300 mm". */
export function gotWords({ got, asked }: Stop, unit: Unit): string {
  const [first, all] = [formatLength(got, unit), formatLength(asked, unit)];
  const space = first.lastIndexOf(" ");
  return `${all.endsWith(first.slice(space)) ? first.slice(0, space) : first} of ${all}`;
}

/** What stops it, in a sentence; `growth` as in RefusedPull. */
export function reasonWords(
  reason: Reason,
  growth: number | null,
  sought: Sought = "searched",
): string {
  const further = sought === "dragged" ? "Dragged on" : "Further";
  if (reason === "unknown" && sought === "dragged")
    return "The drag found no way further; another solve may.";
  if (reason === "unknown") return "No panel is at a limit, but it was not followed further.";
  if (reason === "limits") return `${further}, panels would exceed a limit.`;
  if (reason === "slides") return "Further, joints would slide by more than their limit.";
  if (reason === "keep-outs") return "Further, panels or points would enter a keep-out.";
  if (reason === "panels" || growth === null) return "Further, some would not stay flat and sound.";
  return `${further}, folds would be more than ${formatDegrees(growth)} sharper.`;
}

const WITHIN = "Within the limit";

/** Of a drag that was held back. */
export const within = (growth: number | null): WayOn => ({
  label: WITHIN,
  title: "As far as other panels can share the bend",
  change: {},
  growth: growth ?? Number.POSITIVE_INFINITY,
});

/** Of a target that was given: the furthest place on the way to it, within the limits that are stated. */
const asFarAsItGoes: WayOn = {
  label: "As far as it goes",
  title: "Looks along the way to the target for the furthest place that is met",
  change: {},
  growth: Number.POSITIVE_INFINITY,
};

function wider({ reach, reachLength }: EditSettings, growth: number | null): WayOn[] {
  if (reach === 0 && reachLength === 0) return [];
  const next = reach > 0 && reach + MORE_RINGS <= MOST_RINGS ? reach + MORE_RINGS : 0;
  const label = next > 0 ? `Reach ${next} panels` : "Reach without limit";
  return [
    { label, title: "Lets more points follow", change: { reach: next, reachLength: 0 }, growth },
  ];
}

function softer({ softness: now }: EditSettings, growth: number): WayOn[] {
  if (now === 0 || now === SOFTEST) return [];
  const softness = Math.min(SOFTEST, now + SOFTER);
  const title = `Softness ${softness}: more panels share the fold`;
  return [{ label: "Softer", title, change: { softness }, growth }];
}

function sharper({ report }: Design, growth: number): WayOn {
  const degrees = Math.ceil((report.sharpestFold?.before ?? 0) + growth + MORE_DEGREES);
  const [label, title] = [`Folds up to ${degrees}°`, "Lets panels fold more sharply"];
  return { label, title, change: {}, growth: growth + MORE_DEGREES };
}

/** The limit on slides twice as far. */
function slidingFurther({ limits }: EditSettings): WayOn {
  const changed = limits.map((limit) => {
    const [head, most] = [limitHead(limit), limitNumbers(limit)[0] ?? 0];
    return head === "slide=" ? `${head}${2 * most}` : limit;
  });
  const [label, title] = ["Joints slide twice as far", "Loosens the limit"];
  return { label, title, change: { limits: changed }, growth: null };
}

/** A limit on folds ten degrees further on; any other is taken back. */
function looser({ limits }: EditSettings): WayOn {
  const fold = limits.find((limit) => limit.startsWith("fold="));
  if (!fold) {
    const [label, title] = ["Without limits", "Removes all limits"];
    return { label, title, change: { limits: [] }, growth: null };
  }
  const [head, degrees] = [limitHead(fold), (limitNumbers(fold)[0] ?? 0) + MORE_DEGREES];
  const changed = limits.map((limit) => (limit === fold ? `${head}${degrees}` : limit));
  const label = head === "fold=" ? `Folds up to ${degrees}°` : `Folds sharper by ${degrees}°`;
  return { label, title: "Loosens the limit", change: { limits: changed }, growth: null };
}

const without = (): WayOn => ({
  label: "Without keep-outs",
  title: "Takes all of them back",
  change: { keepOuts: [], clearance: 0 },
  growth: null,
});

/** What a way on gives. */
export interface Gain {
  /** As of a stop; null where every handle is as good as at its target. */
  readonly got: number | null;
  /** The sharpest fold then, degrees; null where nothing moves. */
  readonly fold: number | null;
  /** Panels that it spoils, and how: see damageWords(). */
  readonly spoilt: number;
  readonly damage: string;
}

/** How many times as far is a gain. */
const GAINED = 1.01;

export const isNoFurther = (got: number, before: Stop): boolean => got <= GAINED * before.got;

export const isLess = (got: number, before: Stop): boolean => GAINED * got < before.got;

/** "2168 mm, 16°": how far, and the sharpest fold there. */
export function gainWords({ got, fold }: Gain, before: Stop, unit: Unit): string {
  if (got !== null && isNoFurther(got, before)) return "no further";
  const far = got === null ? "all the way" : formatLength(got, unit);
  return fold === null ? far : `${far}, ${formatDegrees(fold)}`;
}

/** ", 3333 mm sharing the bend": how far a drag that was held back gets within its limit, where that is
 * known and further. */
export function sharedWords(gains: ReadonlyMap<string, Gain>, before: Stop, unit: Unit): string {
  const gain = gains.get(WITHIN);
  if (!gain || (gain.got !== null && isNoFurther(gain.got, before))) return "";
  const far = gain.got === null ? "all the way" : formatLength(gain.got, unit);
  return `, ${far} sharing the bend`;
}

/** Ways that gain something, the furthest first, of those that go as far the one that spoils no panel, then the
 * one that folds least; where none does, all. A way whose gain is not known stays behind those. */
export function byGain(
  ways: readonly WayOn[],
  gains: ReadonlyMap<string, Gain>,
  before: Stop,
): readonly WayOn[] {
  const got = ({ label }: WayOn): number => {
    const gain = gains.get(label);
    return gain ? (gain.got ?? Number.POSITIVE_INFINITY) : Number.NEGATIVE_INFINITY;
  };
  const fold = ({ label }: WayOn): number => gains.get(label)?.fold ?? 0;
  const spoils = ({ label }: WayOn): number => ((gains.get(label)?.spoilt ?? 0) > 0 ? 1 : 0);
  const further = ways.filter((way) => !gains.has(way.label) || !isNoFurther(got(way), before));
  return [...(further.length > 0 ? further : ways)].sort((a, b) => {
    const [first, second] = [got(a), got(b)];
    return first === second ? spoils(a) - spoils(b) || fold(a) - fold(b) : second - first;
  });
}

/** One press each. Those that do not loosen the limit on a drag's folds keep it. */
export function waysOn(
  design: Design,
  reason: Reason,
  growth: number | null,
  sought: Sought = "searched",
): readonly WayOn[] {
  const { settings } = design;
  if (reason === "keep-outs") return [without()];
  const kept = reason === "fold" || reason === "unknown" ? growth : null;
  const first = { dragged: [within(kept)], given: [asFarAsItGoes], searched: [] };
  const ways: WayOn[] = [...first[sought]];
  ways.push(...wider(settings, kept));
  if (kept !== null) ways.push(...softer(settings, kept), sharper(design, kept));
  if (reason === "slides") ways.push(slidingFurther(settings));
  if (reason === "limits" || (reason === "unknown" && kept === null)) ways.push(looser(settings));
  if (settings.keepBoundary) {
    const [label, title] = ["Let the boundary move", "Points on the boundary may follow"];
    ways.push({ label, title, change: { keepBoundary: false }, growth: kept });
  }
  if (!settings.hardHandles) {
    const title = "All the way, however sharp the folds, where flat panels let it";
    ways.push({ label: "Meet it exactly", title, change: { hardHandles: true }, growth: null });
  }
  return ways;
}
