// SPDX-License-Identifier: MIT
// Edits of one session: with the limit that holds a drag back, and the one that keeps folds fair.
import type { PlanishModule, Session } from "@wasm/planish.mjs";
import { fairLimit } from "./fair-folds.ts";
import { furthest } from "./how-far.ts";
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
import {
  arrivalOf,
  arrives,
  between,
  isBound,
  keepsOwn,
  lags,
  longestWay,
  ownBound,
  PullHold,
} from "./pull-limit.ts";
import { insist, Refused } from "./refused.ts";

type EditRequest = Extract<Request, { kind: "edit" }>;

type FewestAnswer = Omit<Extract<Reply, { kind: "fewest" }>, "kind" | "job">;

/** That a drag may wait for its limit. */
const SEARCH_MS = 2000;
/** Frames more that one takes where its time is over before anything holds it back: else a pointer that
 * stands would say nothing. */
const CATCHING_UP = 6;
/** For the frame at the end of a drag, if it was not shown: longer than any takes. */
const FRAME_SECONDS = 10;

/** With the limit that acts on a drag alone as one that is stated. */
function bounded(settings: EditSettings, limit: PullLimit): EditSettings {
  const own = ownBound(limit);
  return own === null ? settings : { ...settings, limits: [...settings.limits, own] };
}

export interface Edited {
  /** Where the handles were held back to; null where they are as asked. */
  readonly taken: HandleList | null;
  /** The limit on folds that the edit has beside those asked for; null for none. */
  readonly stated: string | null;
  /** The handles, where some are on a mirror plane or an axis and were to leave it; else null. */
  readonly placed: HandleList | null;
}

/** Of a drag. */
interface LastFrame {
  readonly arrives: boolean;
  /** Panels are at a limit. */
  readonly bound: boolean;
  /** Its handles, or where they were held back to. */
  readonly shown: HandleList;
}

/** Throws Refused where the session does; it is then as it was. */
export class Edits {
  readonly #module: PlanishModule;
  readonly #session: Session;
  #hold = new PullHold();
  #settings: EditSettings | null = null;

  constructor(module: PlanishModule, session: Session) {
    this.#module = module;
    this.#session = session;
  }

  /** The session has other options now, and no drag goes on. */
  forget(): void {
    this.#hold = new PullHold();
    this.#settings = null;
  }

  edit(request: EditRequest): Edited {
    const placed = this.#onFixedPoints(request.targets.handles);
    if (!placed) return { ...this.#edit(request), placed };
    const targets = { ...request.targets, handles: placed };
    return { ...this.#edit({ ...request, targets }), placed };
  }

  #edit(request: EditRequest): Omit<Edited, "placed"> {
    const { mode, settings, targets, limit } = request;
    if (limit && mode === "drag") return { taken: this.#frame(limit, request), stated: null };
    if (limit) return this.#rest(limit, request);
    this.#hold = new PullHold();
    this.#setOptions(settings);
    const once = (): void => this.#attempt(request, targets.handles, mode);
    once();
    return { taken: null, stated: this.#unfold(request, once) };
  }

  /** null where they are there already. */
  #onFixedPoints(handles: HandleList): HandleList | null {
    const placed = this.#module.onFixedPoints?.(this.#session, Float64Array.from(handles));
    return placed?.some((x, k) => x !== handles[k]) ? [...placed] : null;
  }

  restore({ targets, settings, shape, keep }: Extract<Request, { kind: "restore" }>): void {
    this.#hold = new PullHold();
    this.#setOptions(settings);
    const handles = Float64Array.from(targets.handles);
    const pins = Int32Array.from(targets.pins);
    insist(this.#session.restore(handles, pins, shape.moved, shape.positions, keep));
  }

  split(
    { targets, settings, most }: Extract<Request, { kind: "splitEdit" }>,
    found: (standing: SplitStanding) => void,
  ): SplitFinding {
    this.#hold = new PullHold();
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
    this.#hold = new PullHold();
    this.#setOptions(settings);
    const [handles, pins] = [Float64Array.from(targets.handles), Int32Array.from(targets.pins)];
    const session = this.#session;
    insist(this.#module.fewest(session, handles, pins, withinHandle, mostPanels));
    this.#settings = null;
    const shape = { moved: session.moved(), positions: session.movedPositions() };
    return { shape, report: session.shapeReport(), found: this.#module.fewestFound(session) };
  }

  #attempt({ mode, targets, settings, budget }: EditRequest, to: HandleList, how: EditMode): void {
    const steps = mode === "solve" ? settings.continuation : 0;
    const [handles, pins] = [Float64Array.from(to), Int32Array.from(targets.pins)];
    insist(this.#session.edit(this.#module.EditMode[how], handles, pins, steps, budget));
  }

  /** A frame of a drag; null where its handles arrive. */
  #frame(limit: PullLimit, request: EditRequest): HandleList | null {
    const to = request.targets.handles;
    const session = this.#session;
    this.#setOptions(bounded(request.settings, limit));
    const frames = {
      edit: (handles: HandleList, settled: boolean): boolean => {
        if (settled) session.goBack();
        this.#attempt(request, handles, "drag");
        for (let k = 0; k < CATCHING_UP && lags(limit, handles, session.shapeReport()); ++k)
          this.#attempt(request, handles, "drag");
        return arrives(limit, handles, session.shapeReport());
      },
      keep: () => session.keepEdit(),
      back: () => session.showKept(),
    };
    const taken = this.#hold.take(limit.from, to, frames, SEARCH_MS);
    return taken === to ? null : taken;
  }

  /**
   * The end of a drag, or targets that are given under its limit: as they are where nothing holds them
   * back, else with the limit as a bound of the edit. A drag that was held back ends where it was shown, if
   * an edit of its own gets there; anything else as far as its handles get.
   */
  #rest(limit: PullLimit, request: EditRequest): Omit<Edited, "placed"> {
    const { settings, targets, mode } = request;
    const own = ownBound(limit);
    const last = this.#lastFrame(limit, request);
    if (own !== null && (last === null || (last.arrives && !last.bound))) {
      this.#setOptions(settings);
      this.#attempt(request, targets.handles, mode);
      if (keepsOwn(limit, this.#session.shapeReport())) return { taken: null, stated: null };
    }
    this.#setOptions(bounded(settings, limit));
    if (last && !last.arrives && this.#comesTo(limit, request, last.shown))
      return { taken: last.shown, stated: own };
    return { taken: this.#furthest(limit, request, last?.arrives ? mode : "solve"), stated: own };
  }

  /** Whether an edit of handles that a drag showed meets them; they are ahead of where it began. */
  #comesTo(limit: PullLimit, request: EditRequest, shown: HandleList): boolean {
    const length = longestWay(limit.from, shown);
    if (length === 0) return false;
    this.#attempt(request, shown, "solve");
    return arrivalOf(limit, shown, this.#session.shapeReport(), length).over <= 0;
  }

  /** At the end of a drag, which its own last frame need not have shown; null without a drag. */
  #lastFrame(limit: PullLimit, request: EditRequest): LastFrame | null {
    const dragged = this.#hold.goesOn(limit.from);
    const shown = this.#hold.taken;
    this.#hold = new PullHold();
    if (!dragged) return null;
    const { handles } = request.targets;
    this.#attempt({ ...request, budget: FRAME_SECONDS }, handles, "drag");
    const report = this.#session.shapeReport();
    return { arrives: arrives(limit, handles, report), bound: isBound(report), shown };
  }

  /** null where the handles meet what they are asked to. */
  #furthest(limit: PullLimit, request: EditRequest, first: EditMode): HandleList | null {
    const to = request.targets.handles;
    const session = this.#session;
    const length = longestWay(limit.from, to);
    const share = furthest({
      edit: (at) => {
        const handles = between(limit.from, to, at);
        this.#attempt(request, handles, at === 1 ? first : "solve");
        return arrivalOf(limit, handles, session.shapeReport(), length);
      },
      keep: () => session.keepEdit(),
      back: () => session.showKept(),
    });
    return share === 1 ? null : between(limit.from, to, share);
  }

  /** Makes the edit again with the limit on folds that costs its handles nothing, if there is one. */
  #unfold(request: Extract<Request, { kind: "edit" }>, again: () => void): string | null {
    const { settings, fairWay } = request;
    if (fairWay === null) return null;
    let tried = false;
    const stated = fairLimit(this.#session.shapeReport(), fairWay, (limit) => {
      tried = true;
      this.#setOptions({ ...settings, limits: [...settings.limits, limit] });
      again();
      return this.#session.shapeReport();
    });
    if (tried && stated === null) {
      this.#setOptions(settings);
      again();
    }
    return stated;
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
