// SPDX-License-Identifier: MIT
// Edits of one session: with the limit that holds a drag back, and the one that keeps folds fair.

import { metShare } from "virtual:core-defaults";
import type { PlanishModule, Pulled, PullStanding, Session } from "@wasm/planish.mjs";
import { placesOf, shownIn } from "./as-shown.ts";
import type {
  EditMode,
  EditSettings,
  HandleList,
  PullLimit,
  Reply,
  Request,
  SplitFinding,
  SplitStanding,
} from "./protocol.ts";
import { keepsOwn, longestWay, ownBound } from "./pull-limit.ts";
import { ReachSteps } from "./reach-steps.ts";
import { insist, Refused } from "./refused.ts";

type EditRequest = Extract<Request, { kind: "edit" }>;

type PullWay = keyof PlanishModule["PullWay"];

type FewestAnswer = Omit<Extract<Reply, { kind: "fewest" }>, "kind" | "job">;

/** Iterations of a solve: paths to the same targets take about ten times as many. */
const MOST_FOR_PATHS = 100;
/** For the frame at the end of a drag, if it was not shown: longer than any takes. */
const FRAME_SECONDS = 10;

/** `settings` with the limit that acts on a drag alone as one that is stated. */
function bounded(settings: EditSettings, limit: PullLimit): EditSettings {
  const own = ownBound(limit);
  return own === null ? settings : { ...settings, limits: [...settings.limits, own] };
}

const withReach = (request: EditRequest, reach: number | null): EditRequest =>
  reach === null ? request : { ...request, settings: { ...request.settings, reach } };

/** As the core takes them. */
const arraysOf = ({ targets }: EditRequest, handles: HandleList = targets.handles) => ({
  handles: Float64Array.from(handles),
  pins: Int32Array.from(targets.pins),
});

const stepsOf = ({ mode, settings }: EditRequest): number =>
  mode === "solve" ? settings.continuation : 0;

export interface Edited {
  /** Where the handles were held back to; null where they are as asked. */
  readonly taken: HandleList | null;
  /** Limits that the edit has beside those asked for. */
  readonly found: readonly string[];
  /** Of those tried; null: that of the settings. */
  readonly reach: number | null;
  /** The handles, where some are on a mirror plane or an axis and were to leave it; else null. */
  readonly placed: HandleList | null;
}

/** The last frame of a drag. */
interface LastFrame {
  readonly arrives: boolean;
  /** Panels are at a limit. */
  readonly bound: boolean;
  /** No limit holds the handles back: panels hardly follow, and more frames would not tell. */
  readonly behind: boolean;
  /** The handles asked for, or where they were held back to, or stayed behind. */
  readonly shown: HandleList;
}

/** Throws Refused where the session does; it is then as it was. */
export class Edits {
  readonly #module: PlanishModule;
  readonly #session: Session;
  #reach = new ReachSteps();
  readonly #slivers: () => number;
  #settings: EditSettings | null = null;

  /** @param slivers how many panels became slivers in what the session shows */
  constructor(module: PlanishModule, session: Session, slivers: () => number) {
    this.#module = module;
    this.#session = session;
    this.#slivers = slivers;
  }

  /** The session has other options now, and no drag goes on. */
  forget(): void {
    this.#forgetDrag();
    this.#settings = null;
  }

  #forgetDrag(): void {
    this.#module.forgetDrag(this.#session);
    this.#reach = new ReachSteps();
  }

  edit(request: EditRequest): Edited {
    const placed = this.#onFixedPoints(request.targets.handles);
    if (!placed) return { ...this.#edit(request), placed };
    const targets = { ...request.targets, handles: placed };
    return { ...this.#edit({ ...request, targets }), placed };
  }

  #edit(request: EditRequest): Omit<Edited, "placed"> {
    const { mode, limit } = request;
    if (limit && mode === "drag") return this.#frame(limit, request);
    if (limit) return this.#rest(limit, this.#asDragged(limit, request));
    this.#forgetDrag();
    return this.#given(request);
  }

  /** null where they are there already. */
  #onFixedPoints(handles: HandleList): HandleList | null {
    const placed = this.#module.onFixedPoints?.(this.#session, Float64Array.from(handles));
    return placed?.some((x, k) => x !== handles[k]) ? [...placed] : null;
  }

  restore({ targets, settings, shape, keep }: Extract<Request, { kind: "restore" }>): void {
    this.#forgetDrag();
    this.#setOptions(settings);
    const handles = Float64Array.from(targets.handles);
    const pins = Int32Array.from(targets.pins);
    insist(this.#session.restore(handles, pins, shape.moved, shape.positions, keep));
  }

  split(
    { targets, settings, most }: Extract<Request, { kind: "splitEdit" }>,
    found: (standing: SplitStanding) => void,
  ): SplitFinding {
    this.#forgetDrag();
    this.#setOptions(settings);
    const handles = Float64Array.from(targets.handles);
    const pins = Int32Array.from(targets.pins);
    const answer = this.#module.splitWhereNeeded(this.#session, handles, pins, most, found);
    if (!("curve" in answer)) throw new Refused(answer.problem);
    const { curve, tried, reached } = answer;
    return { curve, tried, reached };
  }

  /** Few panels to make again: from here on the session has what that holds, and its limits. */
  fewest({
    targets,
    settings,
    withinHandle,
    mostPanels,
  }: Extract<Request, { kind: "fewest" }>): FewestAnswer {
    this.#forgetDrag();
    this.#setOptions(settings);
    const [handles, pins] = [Float64Array.from(targets.handles), Int32Array.from(targets.pins)];
    const session = this.#session;
    insist(this.#module.fewest(session, handles, pins, withinHandle, mostPanels));
    this.#settings = null;
    const shape = { moved: session.moved(), positions: session.movedPositions() };
    return { shape, report: session.shapeReport(), found: this.#module.fewestFound(session) };
  }

  #attempt(request: EditRequest, to: HandleList, how: EditMode): void {
    const { handles, pins } = arraysOf(request, to);
    const steps = stepsOf(request);
    insist(this.#session.edit(this.#module.EditMode[how], handles, pins, steps, request.budget));
  }

  /** Targets that are given, with the smallest reach of those tried that suffices. */
  #given(request: EditRequest): Omit<Edited, "placed"> {
    const { reaches, settings, targets, mode, sought } = request;
    const last = reaches.at(-1) ?? null;
    for (const reach of sought ? reaches.slice(0, -1) : []) {
      this.#setOptions({ ...settings, reach });
      this.#attempt(request, targets.handles, mode);
      const { status } = this.#session.shapeReport();
      const suffices = this.#module.suffices(this.#session, sought?.way ?? 0, metShare);
      if (status === "converged" && suffices && this.#slivers() === 0)
        return { taken: null, found: [], reach };
    }
    return { taken: null, found: this.#fairly(withReach(request, last)), reach: last };
  }

  /** With the reach of the drag that ends, whose own last frame need not have been shown. */
  #asDragged(limit: PullLimit, request: EditRequest): EditRequest {
    this.#growReach(limit, { ...request, budget: FRAME_SECONDS });
    return withReach(request, this.#reach.now);
  }

  #growReach(limit: PullLimit, request: EditRequest): void {
    if (this.#reach.begins(limit.from, request.reaches)) this.#session.keepEdit();
    while (!this.#reach.isLast && !this.#follows(limit, request)) this.#reach.grow();
  }

  /** A frame of a drag. */
  #frame(limit: PullLimit, request: EditRequest): Omit<Edited, "placed"> {
    this.#growReach(limit, request);
    const { isLast, now: reach } = this.#reach;
    const taken = isLast ? this.#held(limit, withReach(request, reach)) : null;
    return { taken, found: [], reach };
  }

  /** Whether a frame of the reach that there is suffices: else what is shown is the frame before. */
  #follows(limit: PullLimit, request: EditRequest): boolean {
    this.#setOptions(bounded(withReach(request, this.#reach.now).settings, limit));
    return this.#pull("near", limit, request).suffices;
  }

  /** A frame that a limit may hold back; null where its handles arrive. */
  #held(limit: PullLimit, request: EditRequest): HandleList | null {
    this.#setOptions(bounded(request.settings, limit));
    return this.#takenBy("hold", limit, request);
  }

  #pull(way: PullWay, limit: PullLimit, request: EditRequest): Pulled {
    const { handles, pins } = arraysOf(request);
    const [how, steps] = [this.#module.PullWay[way], stepsOf(request)];
    const asked = [how, handles, pins, steps, request.budget, limit] as const;
    const pulled = this.#module.pull(this.#session, ...asked);
    insist(pulled.problem);
    return pulled;
  }

  /** Where a pull takes handles back to; null where they are as asked. */
  #takenBy(way: PullWay, limit: PullLimit, request: EditRequest): HandleList | null {
    const { taken } = this.#pull(way, limit, request);
    return taken && [...taken];
  }

  #standing(limit: PullLimit, handles: HandleList): PullStanding {
    return this.#module.pullStanding(this.#session, Float64Array.from(handles), limit);
  }

  /**
   * The end of a drag, or targets that are given under its limit: as they are where nothing holds them
   * back, else with the limit as a bound of the edit. A drag that was held back ends where it was shown, if
   * an edit of its own gets there; anything else as far as its handles get.
   */
  #rest(limit: PullLimit, request: EditRequest): Omit<Edited, "placed"> {
    const { settings, targets, mode } = request;
    const own = ownBound(limit);
    const reach = this.#reach.now;
    const found = own === null ? [] : [own];
    const last = this.#lastFrame(limit, request);
    if (own !== null && (last === null || (last.arrives && !last.bound))) {
      this.#setOptions(settings);
      this.#attempt(request, targets.handles, mode);
      if (keepsOwn(limit, this.#session.shapeReport())) return { taken: null, found: [], reach };
    }
    this.#setOptions(bounded(settings, limit));
    if (last && !last.arrives && this.#comesTo(limit, request, last))
      return { taken: last.shown, found, reach };
    const way = last?.arrives && mode === "release" ? mode : "furthest";
    return { taken: this.#takenBy(way, limit, request), found, reach };
  }

  /** Whether an edit of handles that a drag showed meets them, or comes as near as the drag, or as far as
   * panels follow; they are ahead of where it began. */
  #comesTo(limit: PullLimit, request: EditRequest, { shown, behind }: LastFrame): boolean {
    const length = longestWay(limit.from, shown);
    if (length === 0) return false;
    const short = longestWay(placesOf(this.#session, shown, limit.base), shown);
    // No path leads to what frames left behind.
    if (behind) this.#attempt(request, shown, "solve");
    else this.#endAt(limit, request, shown);
    const { isStuck, arrives } = this.#standing(limit, shown);
    if (isStuck) return false;
    return arrives || behind || this.#session.shapeReport().handleError <= short;
  }

  /** Of handles that a drag showed; where frames had settled to another shape, along a path that has that, if any. */
  #endAt(limit: PullLimit, request: EditRequest, shown: HandleList): void {
    const session = this.#session;
    const hadSettled = session.shapeReport().status === "converged";
    const isAsShown = shownIn(session);
    session.keepEdit();
    this.#attempt(request, shown, "solve");
    if (!hadSettled || session.shapeReport().iterations > MOST_FOR_PATHS) return;
    if (isAsShown(longestWay(limit.base, shown))) return;
    session.showKept();
    this.#attempt(request, shown, "release");
  }

  /** How a drag ended, which its own last frame need not have shown; null without a drag. */
  #lastFrame(limit: PullLimit, request: EditRequest): LastFrame | null {
    const { handles } = request.targets;
    const [from, to] = [Float64Array.from(limit.from), Float64Array.from(handles)];
    const { goesOn, isHeldBack, taken } = this.#module.lastPull(this.#session, from, to);
    const shown = [...taken];
    this.#forgetDrag();
    if (!goesOn) return null;
    // Whoever lets go there has seen how far it goes, be it for want of time.
    const behind = this.#standing(limit, shown).lags;
    if (isHeldBack && behind) return this.#leftBehind(limit, handles, true);
    if (isHeldBack) return { arrives: false, bound: true, behind, shown };
    this.#pull("follow", limit, { ...request, budget: FRAME_SECONDS });
    const { isBound: bound, lags, arrives } = this.#standing(limit, handles);
    if (lags) return this.#leftBehind(limit, handles, bound);
    return { arrives, bound, behind: false, shown };
  }

  /** What is shown is all that panels follow. */
  #leftBehind(limit: PullLimit, handles: HandleList, bound: boolean): LastFrame {
    return {
      arrives: false,
      bound,
      behind: true,
      shown: placesOf(this.#session, handles, limit.base),
    };
  }

  /** Makes the edit, where limits are sought with those that cost its handles nothing: these. */
  #fairly(request: EditRequest): readonly string[] {
    const { mode, settings, sought, targets, budget } = request;
    this.#setOptions(settings);
    if (!sought) {
      this.#attempt(request, targets.handles, mode);
      return [];
    }
    const { handles, pins } = arraysOf(request);
    const [how, steps] = [this.#module.EditMode[mode], stepsOf(request)];
    this.#settings = null; // where it is refused, which the session has is not known
    const answer = [handles, pins, steps, budget, sought] as const;
    insist(this.#module.editFairly(this.#session, how, ...answer));
    const found = this.#module.fairFound(this.#session);
    this.#settings = { ...settings, limits: [...settings.limits, ...found], continuation: 0 };
    return found;
  }

  /** Options that stay the same keep the solver's warm start; each message is a copy. */
  #setOptions(given: EditSettings): void {
    const settings = { ...given, continuation: 0 }; // each edit has its own
    if (JSON.stringify(settings) === JSON.stringify(this.#settings)) return;
    this.#settings = null; // where one of them is refused, the others hold already
    insist(this.#session.setOptions(settings));
    insist(this.#session.setSupports(settings.supports));
    this.#settings = settings;
  }
}
