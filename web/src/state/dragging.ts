// SPDX-License-Identifier: MIT
// A drag moves the chosen points together: frames while it lasts, one step of the history after.

import { noticeableShare } from "virtual:core-defaults";
import {
  DEFAULT_SETTINGS,
  type Design,
  type HandleRow,
  leftBehind,
  type Point,
  toTargets,
  withHandle,
  withTaken,
} from "../design/design.ts";
import { type Frame, pointFrame } from "../mesh/point-frame.ts";
import { add } from "../mesh/vector.ts";
import { boundNames } from "../solver/bounds.ts";
import type { Question } from "../solver/client.ts";
import { foldGrowth, isFound, stepOf } from "../solver/found-limits.ts";
import type { EditSettings, HandleList, PullLimit } from "../solver/protocol.ts";
import { enqueue, type Outcome } from "./action-queue.ts";
import { client, frame } from "./connection.ts";
import {
  basePoint,
  commitEdit,
  editQuestion,
  freePins,
  handleOf,
  longestWay,
  setPinned,
  shownPoint,
  speaking,
} from "./editing.ts";
import { moveWeights } from "./fall-off.ts";
import { formatDegrees } from "./fold.ts";
import { shownTab } from "./inspector.ts";
import { lastLeftBehind } from "./left-behind.ts";
import { movesShown } from "./moves.ts";
import type { Page } from "./page.ts";
import type { Lock } from "./page-state.ts";
import { noteReachOfSource, reachesFor } from "./reach-choice.ts";
import { growthOf, lastRefusedPull } from "./refused-pull.ts";
import { lastSettling } from "./settling.ts";
import { showPresent } from "./showing.ts";

/** Where a drag of a point starts: at its target, unless a variation has taken the point away from
 * it; without a target where it is. */
export function askedPoint(page: Page, vertex: number): Point {
  const design = page.draft.value;
  const target = design && !leftBehind(design) ? handleOf(page, vertex)?.target : null;
  return target ?? shownPoint(page, vertex);
}

/** The directions of the surface at a point, as the design stands now. */
export function frameAt(page: Page, vertex: number): Frame | null {
  return page.mesh.value ? pointFrame(page.mesh.value, (v) => shownPoint(page, v), vertex) : null;
}

function withTargets(page: Page, grips: readonly Grip[], offset: Point): HandleRow[] {
  const before = page.draft.value?.handles ?? [];
  let rows: readonly HandleRow[] = before;
  for (const { vertex, from, weight } of grips) {
    rows = withHandle(rows, { vertex, target: add(from, offset, weight), pinned: false });
  }
  return speaking(page, before, rows);
}

interface Grip {
  readonly vertex: number;
  readonly from: Point;
  /** The share of the drag that it takes part in. */
  readonly weight: number;
}

const scale = ([x, y, z]: Point, by: number): Point => [by * x, by * y, by * z];

/** Frames more of a pointer that rests: most settle by two, and some shapes never do. */
const MOST_RESTS = 24;

const END_ON = "This direction points at you: turn the view, or type the coordinate.";

/** What the usual line of a drag allows, to somebody who pulls elsewhere. */
const ASIDE = { up: "It goes up and down only: ", out: "It goes in and out only: " } as const;

/** A finger has no Alt. */
const FREED = {
  byKey: "hold Alt to move it freely.",
  byFinger: "lift your finger, then choose another axis above.",
} as const;

const isAside = (said: string | null): boolean =>
  Object.values(ASIDE).some((words) => said?.startsWith(words));

const HELD = "Held back: ";

/** What holds a drag back: its own limit on folds by `degrees`, where it is finite, or stated limits; those of
 * `at`, which panels are at. Shift goes through its own, also where the search for a way within it ended early;
 * fingers have none. */
export function heldWords(at: readonly string[], degrees: number, byFinger: boolean): string {
  const own = degrees < Number.POSITIVE_INFINITY;
  const through = own && !byFinger ? " Shift goes through." : "";
  if (at.length === 0)
    return `${HELD}no panel is at a limit, but it was not followed further.${through}`;
  if (!own || !at.includes("fold")) return `${HELD}further, panels would exceed a limit.`;
  const others = at.some((name) => name !== "fold") ? ", or exceed a limit" : "";
  return `${HELD}further, panels would fold more than ${formatDegrees(degrees)} sharper${others}.${through}`;
}

const isHeldBack = (said: string | null): boolean => said?.startsWith(HELD) ?? false;

/** How much handles stop short, as a share of the longest way of one in the design shown. */
function shortShare(page: Page): number {
  const way = longestWay(page, page.history.value?.present.handles ?? []);
  return way > 0 ? page.figures.value.handleError / way : 0;
}

/** `design` without the limit on folds that the page found for an edit before: a drag has its own. */
function unbound(page: Page, design: Design): Design {
  const { limits } = design.settings;
  const stated = limits.filter((limit) => !isFound(limit, page.statedLimits.value));
  if (stated.length === limits.length) return design;
  return { ...design, settings: { ...design.settings, limits: stated } };
}

/** Whether the drag's own limit on folds acts: not where the raw weights hold, or where one is stated. */
const ownLimit = ({ softness, limits }: EditSettings): boolean =>
  softness > 0 && !limits.some((limit) => limit.startsWith("fold="));

/**
 * What holds a drag back; null: nothing. One that starts with sharper folds, or with handles further
 * from their targets, may keep them.
 */
function pullLimit(page: Page, settings: EditSettings, grips: readonly Grip[]): PullLimit | null {
  const [own, stated] = [ownLimit(settings), settings.limits.length > 0];
  if (!own && !stated) return null;
  const rows = withTargets(page, grips, [0, 0, 0]);
  return {
    degrees: own ? stepOf(foldGrowth(page.figures.value)) : Number.POSITIVE_INFINITY,
    short: Math.max(settings.softness > 0 ? 0 : noticeableShare, shortShare(page)),
    from: toTargets(rows).handles,
    base: toTargets(rows.map((row) => ({ ...row, target: basePoint(page, row.vertex) }))).handles,
  };
}

/** One drag; model units. The last of its points leads: it goes all the way. An offset of exactly 0 along an axis keeps that coordinate's bits. */
export class Drag {
  readonly #page: Page;
  readonly #grips: readonly Grip[];
  /** What the drag began with; a lock chosen while it lasts ends with it. */
  readonly #lock: Lock | null;
  readonly #limit: PullLimit | null;
  readonly #isStated: boolean;
  readonly #reaches: readonly number[];
  /** Whether a finger drags, beside which no key is held. */
  byFinger = false;
  #through = false;
  #over = false;
  /** Model units: a pull this long was held back. */
  #furthest = Number.POSITIVE_INFINITY;
  /** As the last move asked for them; the draft has others where they were held back. */
  #asked: readonly HandleRow[] = [];

  constructor(page: Page, vertices: readonly number[]) {
    this.#page = page;
    this.#lock = page.lock.value;
    const weights = moveWeights(page, vertices, vertices.at(-1) ?? null);
    this.#grips = vertices.map((vertex, k) => {
      return { vertex, from: askedPoint(page, vertex), weight: weights[k] ?? 1 };
    });
    const settings = page.draft.value ? unbound(page, page.draft.value).settings : DEFAULT_SETTINGS;
    this.#isStated = settings.limits.length > 0;
    this.#limit = pullLimit(page, settings, this.#grips);
    if (page.draft.value) noteReachOfSource(page, page.draft.value);
    this.#reaches = page.draft.value ? reachesFor(page, page.draft.value) : [];
    page.pull.value = { vertex: this.#grips.at(-1)?.vertex ?? -1, typed: "" };
    movesShown(page); // They follow the frames from here on.
  }

  /** `through` the limit on folds. */
  by(offset: Point, through = false): void {
    if (!this.#page.draft.value) return;
    const design = unbound(this.#page, this.#page.draft.value);
    this.#page.hintVertex.value = null;
    if (this.#page.notice.value === END_ON) this.#page.notice.value = null;
    this.#through = through;
    const asked = { ...design, handles: withTargets(this.#page, this.#grips, offset) };
    this.#asked = asked.handles;
    const tried = { limit: this.#limitFor(through), reaches: this.#reaches };
    void this.#show(asked, editQuestion(asked, "drag", tried));
    const share = this.#limitFor(through) ? Math.min(1, this.#furthest / Math.hypot(...offset)) : 1;
    const handles =
      share < 1 ? withTargets(this.#page, this.#grips, scale(offset, share)) : asked.handles;
    this.#page.draft.value = { ...asked, handles };
    if (share < 1) this.#want(null);
  }

  /** The limit of a drag; nothing goes through what was stated. */
  #limitFor(through: boolean): PullLimit | null {
    if (!through || !this.#limit) return this.#limit;
    return this.#isStated ? { ...this.#limit, degrees: Number.POSITIVE_INFINITY } : null;
  }

  #want(design: Design | null): void {
    const degrees = this.#limitFor(this.#through)?.degrees ?? Number.POSITIVE_INFINITY;
    const growth = growthOf(degrees);
    lastRefusedPull(this.#page).value = { handles: this.#asked, growth, dragged: true, design };
  }

  /** @param over no key goes through any more */
  #sayHeld(over: boolean): void {
    const degrees = this.#limitFor(this.#through)?.degrees ?? Number.POSITIVE_INFINITY;
    const at = boundNames(this.#page.figures.value);
    this.#page.notice.value = heldWords(at, degrees, over || this.byFinger);
  }

  /** The targets go back to where the solver took them. Where the pointer rests, frames that had no time to
   * settle go on, so that what is let go of is what is shown. */
  async #show(asked: Design, question: Question, rests = MOST_RESTS): Promise<void> {
    const answer = await frame(this.#page, question);
    if (answer?.kind !== "shown" || this.#over || !this.#page.draft.value) return;
    const settles = answer.report.status === "iteration_limit" && answer.changes.length > 0;
    if (rests > 0 && settles && asked.handles === this.#asked)
      void this.#show(asked, question, rests - 1);
    const { taken, reach } = answer;
    if (reach !== null) this.#reachesTo(reach);
    this.#furthest = taken ? this.#pull(taken) : Number.POSITIVE_INFINITY;
    if (taken) {
      this.#page.draft.value = {
        ...this.#page.draft.value,
        handles: withTaken(asked.handles, taken),
      };
      this.#want(null);
    } else this.#letGo();
    if (taken) this.#sayHeld(false);
    else if (isHeldBack(this.#page.notice.value)) this.#page.notice.value = null;
  }

  /** The line of the reach follows. */
  #reachesTo(reach: number): void {
    const { draft } = this.#page;
    if (!draft.value || draft.value.settings.reach === reach) return;
    draft.value = { ...draft.value, settings: { ...draft.value.settings, reach } };
  }

  /** Lets go of the pull, which nothing holds back. */
  #letGo(): void {
    if (lastRefusedPull(this.#page).value?.design === null)
      lastRefusedPull(this.#page).value = null;
  }

  /** How far the leading point is pulled. */
  #pull(taken: HandleList): number {
    const { vertex, from } = this.#grips.at(-1) ?? { vertex: -1, from: [0, 0, 0] };
    for (let k = 0; k < taken.length; k += 4) {
      if (taken[k] !== vertex) continue;
      return Math.hypot(...from.map((x, axis) => (taken[k + 1 + axis] ?? x) - x));
    }
    return Number.POSITIVE_INFINITY;
  }

  /** The pointer leaves the line that holds the point: its direction upwards. Null: it does not. */
  goesAside(up: number | null): void {
    const { notice } = this.#page;
    if (up === null && isAside(notice.value)) notice.value = null;
    if (up === null || isHeldBack(notice.value)) return;
    const freed = this.byFinger ? FREED.byFinger : FREED.byKey;
    notice.value = `${up === 1 ? ASIDE.up : ASIDE.out}${freed}`;
  }

  /** The line that it is held to points at the viewer: no place on screen says how far along. */
  endOn(): void {
    this.#page.notice.value = END_ON;
  }

  #finish(): void {
    this.#over = true;
    this.goesAside(null);
    this.#page.pull.value = null;
    this.#page.lock.value = this.#lock;
    client(this.#page).dropStreams();
  }

  /** What was asked for, with the other handles as the design has them now: another drag may have settled since. */
  #askedOf({ handles }: Design): readonly HandleRow[] {
    const settled = new Map(handles.map((row) => [row.vertex, row] as const));
    for (const { vertex } of this.#grips) settled.delete(vertex);
    return this.#asked.map((row) => settled.get(row.vertex) ?? row);
  }

  #noteSettling(design: Design): void {
    const most = movesShown(this.#page)?.farthest ?? 0;
    const pull = longestWay(this.#page, this.#asked);
    lastSettling(this.#page).value = { design, most, pull };
  }

  /** What the last frame showed stays in view until the design is there that takes its place; nothing of it is
   * recorded before. */
  end(): Outcome {
    this.#finish();
    return enqueue(this.#page, async () => {
      const { value } = this.#page.draft;
      const present = this.#page.history.value?.present;
      if (!value || !present || value === present) return;
      const design = { ...value, handles: this.#askedOf(present) };
      const limit = this.#limitFor(this.#through);
      const tried = { limit, reaches: this.#reaches };
      movesShown(this.#page)?.mark();
      const isAtLimit = boundNames(this.#page.figures.value).length > 0;
      const made = await commitEdit(this.#page, design, "release", null, tried);
      if (made?.ok) this.#noteSettling(made.value);
      this.#letGo();
      if (!made?.ok || made.value.handles === design.handles) return made;
      this.#sayHeld(true);
      this.#want(made.value);
      lastLeftBehind(this.#page).value = isAtLimit ? null : made.value;
      // The Edit tab says why, and what goes further.
      shownTab(this.#page).value = "edit";
      return made;
    });
  }

  /** Escape: the design goes back to where it was. */
  abandon(): Outcome {
    if (isHeldBack(this.#page.notice.value)) this.#page.notice.value = null;
    this.#letGo();
    this.#finish();
    return enqueue(this.#page, () => showPresent(this.#page));
  }
}

const isPinned = (page: Page, vertex: number): boolean => handleOf(page, vertex)?.pinned === true;

/** Why points of a mesh that is not flat cannot be moved. */
export const FLAT_FIRST = "First planarise it, or edit it as it is.";

/** Takes hold of points; null if they cannot be moved, and the notice says why. */
export function beginDrag(page: Page, vertices: readonly number[]): Drag | null {
  if (!page.ready.value || !page.mesh.value) return null;
  if (!page.baseFlat.value) {
    page.notice.value = FLAT_FIRST;
    return null;
  }
  const loose = vertices.filter((vertex) => !isPinned(page, vertex));
  if (loose.length === 0) {
    page.notice.value =
      vertices.length === 1 ? `Point ${vertices[0]} is pinned.` : "These are pinned.";
    return null;
  }
  return new Drag(page, loose);
}

/** Holds drags to an axis, or to the plane across it; the same again lets go. */
export function toggleLock(page: Page, axis: Lock["axis"], plane: boolean): void {
  const same = page.lock.value?.axis === axis && page.lock.value.plane === plane;
  page.lock.value = same ? null : { axis, plane };
}

export const allPinned = (page: Page): boolean =>
  page.selection.value.length > 0 && page.selection.value.every((vertex) => isPinned(page, vertex));

/** Pins what is selected, or lets it go if all of it is pinned. */
export function togglePins(page: Page): void {
  if (!page.ready.value || page.readOnly.value) return;
  if (!page.baseFlat.value) page.notice.value = FLAT_FIRST;
  else if (allPinned(page)) void freePins(page, page.selection.value);
  else void setPinned(page, page.selection.value, true);
}
