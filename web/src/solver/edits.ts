// SPDX-License-Identifier: MIT
// Edits of one session: with the limit that holds a drag back, and the one that keeps folds fair.
import type { PlanishModule, Session } from "@wasm/planish.mjs";
import { fairLimit } from "./fair-folds.ts";
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
import { isWithin, PullHold } from "./pull-limit.ts";
import { insist, Refused } from "./refused.ts";

type EditRequest = Extract<Request, { kind: "edit" }>;

type FewestAnswer = Omit<Extract<Reply, { kind: "fewest" }>, "kind" | "job">;

/** That a drag may wait for its limit. */
const SEARCH_MS = 2000;

export interface Edited {
  /** Where the handles were held back to; null where they are as asked. */
  readonly taken: HandleList | null;
  /** The limit on folds that was stated for the edit; null for none. */
  readonly stated: string | null;
  /** The handles, where some are on a mirror plane or an axis and were to leave it; else null. */
  readonly placed: HandleList | null;
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
    this.#setOptions(request.settings);
    const placed = this.#onFixedPoints(request.targets.handles);
    if (!placed) return { ...this.#edit(request), placed };
    const targets = { ...request.targets, handles: placed };
    return { ...this.#edit({ ...request, targets }), placed };
  }

  #edit(request: EditRequest): Omit<Edited, "placed"> {
    const { mode, targets, limit } = request;
    if (limit) return { taken: this.#within(limit, request), stated: null };
    this.#hold = new PullHold();
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
  fewest({ targets, settings, withinHandle }: Extract<Request, { kind: "fewest" }>): FewestAnswer {
    this.#hold = new PullHold();
    this.#setOptions(settings);
    const [handles, pins] = [Float64Array.from(targets.handles), Int32Array.from(targets.pins)];
    const session = this.#session;
    insist(this.#module.fewest(session, handles, pins, withinHandle));
    this.#settings = null;
    const shape = { moved: session.moved(), positions: session.movedPositions() };
    return { shape, report: session.shapeReport(), found: this.#module.fewestFound(session) };
  }

  #attempt({ mode, targets, settings, budget }: EditRequest, to: HandleList, how: EditMode): void {
    const steps = mode === "solve" ? settings.continuation : 0;
    const [handles, pins] = [Float64Array.from(to), Int32Array.from(targets.pins)];
    insist(this.#session.edit(this.#module.EditMode[how], handles, pins, steps, budget));
  }

  /** null where the handles reach what they are asked to. */
  #within(limit: PullLimit, request: EditRequest): HandleList | null {
    const { mode, targets } = request;
    const session = this.#session;
    if (mode !== "drag") this.#hold = new PullHold();
    const once = (handles: HandleList, settled: boolean): boolean => {
      if (settled && mode === "drag") session.goBack();
      this.#attempt(request, handles, settled && mode !== "drag" ? "solve" : mode);
      return isWithin(limit, session.shapeReport());
    };
    const patience = mode === "drag" ? SEARCH_MS : Number.POSITIVE_INFINITY;
    const taken = this.#hold.take(limit.from, targets.handles, once, patience);
    if (mode === "drag") session.keepFrame();
    return taken === targets.handles ? null : taken;
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
