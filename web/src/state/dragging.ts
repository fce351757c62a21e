// SPDX-License-Identifier: MIT
// A drag moves the chosen points together: frames while it lasts, one step of the history after.
import { add, type Frame, pointFrame } from "../mesh/point-frame.ts";
import type { Question } from "../solver/client.ts";
import { foldGrowth } from "../solver/fair-folds.ts";
import type { EditSettings } from "../solver/protocol.ts";
import type { HandleList, PullLimit } from "../solver/pull-limit.ts";
import { client, frame } from "./connection.ts";
import {
  DEFAULT_SETTINGS,
  type Design,
  type HandleRow,
  leftBehind,
  type Point,
  toTargets,
  withHandle,
  withTaken,
} from "./design.ts";
import {
  commitEdit,
  edit,
  editQuestion,
  freePins,
  handleOf,
  setPinned,
  shownPoint,
} from "./editing.ts";
import { formatDegrees } from "./fold.ts";
import { showPresent } from "./showing.ts";
import { NOTICEABLE } from "./stopping-short.ts";
import {
  baseFlat,
  draft,
  figures,
  hintVertex,
  history,
  type Lock,
  lock,
  mesh,
  notice,
  problem,
  readOnly,
  ready,
  selection,
} from "./store.ts";
import { inTurn } from "./turns.ts";
import { wanted } from "./wanted.ts";

/** Where a drag of a point starts: at its target, unless a variation has taken the point away from
 * it; without a target where it is. */
export function askedPoint(vertex: number): Point {
  const design = draft.value;
  const target = design && !leftBehind(design) ? handleOf(vertex)?.target : null;
  return target ?? shownPoint(vertex);
}

/** The directions of the surface at a point, as the design stands now. */
export function frameAt(vertex: number): Frame | null {
  return mesh.value ? pointFrame(mesh.value, shownPoint, vertex) : null;
}

function withTargets(grips: readonly Grip[], offset: Point): HandleRow[] {
  let rows: readonly HandleRow[] = draft.value?.handles ?? [];
  for (const { vertex, from } of grips) {
    rows = withHandle(rows, { vertex, target: add(from, offset), pinned: false });
  }
  return [...rows];
}

interface Grip {
  readonly vertex: number;
  readonly from: Point;
}

const scale = ([x, y, z]: Point, by: number): Point => [by * x, by * y, by * z];

const END_ON = "This direction points at you: turn the view, or type the coordinate.";

/** Degrees by which a drag may sharpen a fold. */
const FOLD_GROWTH = 10;

const HELD = "Held back: ";

/** By its own limit on folds, or by limits that are stated. */
function heldBack(limit: PullLimit | null): string {
  const degrees = limit && limit.degrees < Number.POSITIVE_INFINITY ? limit.degrees : null;
  const stated = (draft.value?.settings.limits.length ?? 0) > 0;
  if (degrees === null) return `${HELD}further, panels would exceed a limit that you stated.`;
  return `${HELD}further, panels would fold more than ${formatDegrees(degrees)} sharper${stated ? ", or exceed a limit that you stated" : ""}. Shift goes through.`;
}

const isHeldBack = (said: string | null): boolean => said?.startsWith(HELD) ?? false;

/** Whether the drag's own limit on folds acts: not where the raw weights hold, or where one is stated. */
const ownLimit = ({ softness, limits }: EditSettings): boolean =>
  softness > 0 && !limits.some((limit) => limit.startsWith("fold="));

/**
 * What holds a drag back; null: nothing. One that starts with sharper folds, or with handles further
 * from their targets, may keep them.
 */
function pullLimit(grips: readonly Grip[]): PullLimit | null {
  const settings = draft.value?.settings ?? DEFAULT_SETTINGS;
  const [own, stated] = [ownLimit(settings), settings.limits.length > 0];
  if (!own && !stated) return null;
  const { handleError, maxDisplacement } = figures.value;
  const short = maxDisplacement > 0 ? handleError / maxDisplacement : 0;
  return {
    degrees: own ? Math.max(FOLD_GROWTH, foldGrowth(figures.value)) : Number.POSITIVE_INFINITY,
    short: stated ? Math.max(NOTICEABLE, short) : Number.POSITIVE_INFINITY,
    from: toTargets(withTargets(grips, [0, 0, 0])).handles,
  };
}

/** One drag; model units. An offset of exactly 0 along an axis keeps that coordinate's bits. */
export class Drag {
  readonly #grips: readonly Grip[];
  /** What the drag began with; a lock chosen while it lasts ends with it. */
  readonly #lock = lock.value;
  readonly #limit: PullLimit | null;
  #through = false;
  #over = false;
  /** Model units: a pull this long was held back. */
  #furthest = Number.POSITIVE_INFINITY;
  /** As the last move asked for them; the draft has others where they were held back. */
  #asked: readonly HandleRow[] = [];

  constructor(vertices: readonly number[]) {
    this.#grips = vertices.map((vertex) => ({ vertex, from: askedPoint(vertex) }));
    this.#limit = pullLimit(this.#grips);
  }

  /** `through` the limit on folds. */
  by(offset: Point, through = false): void {
    const design = draft.value;
    if (!design) return;
    hintVertex.value = null;
    if (notice.value === END_ON) notice.value = null;
    this.#through = through;
    const asked = { ...design, handles: withTargets(this.#grips, offset) };
    this.#asked = asked.handles;
    void this.#show(asked, editQuestion(asked, "drag", this.#limitFor(through)));
    const share = this.#limitFor(through) ? Math.min(1, this.#furthest / Math.hypot(...offset)) : 1;
    const handles = share < 1 ? withTargets(this.#grips, scale(offset, share)) : asked.handles;
    draft.value = { ...asked, handles };
    if (share < 1) this.#want(null);
  }

  /** Nothing goes through what was stated. */
  #limitFor(through: boolean): PullLimit | null {
    if (!through || !this.#limit) return this.#limit;
    const stated = this.#limit.short < Number.POSITIVE_INFINITY;
    return stated ? { ...this.#limit, degrees: Number.POSITIVE_INFINITY } : null;
  }

  #want(design: Design | null): void {
    const degrees = this.#limit?.degrees ?? Number.POSITIVE_INFINITY;
    const growth = Number.isFinite(degrees) ? degrees : null;
    wanted.value = { handles: this.#asked, growth, design };
  }

  /** The targets go back to where the solver took them. */
  async #show(asked: Design, question: Question): Promise<void> {
    const answer = await frame(question);
    if (answer?.kind !== "shown" || this.#over || !draft.value) return;
    const { taken } = answer;
    this.#furthest = taken ? this.#pull(taken) : Number.POSITIVE_INFINITY;
    if (taken) {
      draft.value = { ...draft.value, handles: withTaken(asked.handles, taken) };
      this.#want(null);
    } else this.#letGo();
    if (taken) notice.value = heldBack(this.#limit);
    else if (isHeldBack(notice.value)) notice.value = null;
  }

  /** Nothing holds the pull back. */
  #letGo(): void {
    if (wanted.value?.design === null) wanted.value = null;
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

  /** The line that it is held to points at the viewer: no place on screen says how far along. */
  endOn(): void {
    notice.value = END_ON;
  }

  async end(): Promise<void> {
    this.#over = true;
    lock.value = this.#lock;
    client.dropStreams();
    await inTurn(async () => {
      const design = draft.value;
      if (!design || design === history.value?.present) return;
      const held = design.handles !== this.#asked;
      await commitEdit(design, "release", null, this.#limitFor(this.#through));
      const takenBack = !problem.value && draft.value?.handles !== design.handles;
      this.#letGo();
      if (!held && !takenBack) return;
      notice.value = heldBack(this.#limit);
      if (!problem.value) this.#want(history.value?.present ?? null);
    });
  }

  /** Escape: the design goes back to where it was. */
  async abandon(): Promise<void> {
    this.#over = true;
    if (isHeldBack(notice.value)) notice.value = null;
    this.#letGo();
    lock.value = this.#lock;
    client.dropStreams();
    await inTurn(showPresent);
  }
}

const isPinned = (vertex: number): boolean => handleOf(vertex)?.pinned === true;

/** Why points of a mesh that is not flat cannot be moved. */
export const FLAT_FIRST = "Make it flat first: Planarise.";

/** Takes hold of points; null if they cannot be moved, and the notice says why. */
export function beginDrag(vertices: readonly number[]): Drag | null {
  if (!ready.value || !mesh.value) return null;
  if (!baseFlat.value) {
    notice.value = FLAT_FIRST;
    return null;
  }
  const loose = vertices.filter((vertex) => !isPinned(vertex));
  if (loose.length === 0) {
    notice.value = vertices.length === 1 ? `Point ${vertices[0]} is pinned.` : "These are pinned.";
    return null;
  }
  return new Drag(loose);
}

/** Moves points by the same typed amounts; model units. */
export async function moveTogether(vertices: readonly number[], by: Point): Promise<void> {
  hintVertex.value = null;
  await edit((rows) => {
    let next = [...rows];
    for (const vertex of vertices.filter((v) => !isPinned(v))) {
      next = withHandle(next, { vertex, target: add(askedPoint(vertex), by), pinned: false });
    }
    return next;
  });
}

/** Moves points by typed amounts along their own surface and out of it. */
export async function moveInFrame(
  vertices: readonly number[],
  [along, across, out]: Point,
): Promise<void> {
  hintVertex.value = null;
  await edit((rows) => {
    let next = [...rows];
    for (const vertex of vertices.filter((v) => !isPinned(v))) {
      const at = frameAt(vertex);
      if (!at) continue;
      const sideways = add(add(askedPoint(vertex), at.along, along), at.across, across);
      next = withHandle(next, { vertex, target: add(sideways, at.normal, out), pinned: false });
    }
    return next;
  });
}

/** Holds drags to an axis, or to the plane across it; the same again lets go. */
export function toggleLock(axis: Lock["axis"], plane: boolean): void {
  const same = lock.value?.axis === axis && lock.value.plane === plane;
  lock.value = same ? null : { axis, plane };
}

export const allPinned = (): boolean =>
  selection.value.length > 0 && selection.value.every(isPinned);

/** Pins what is selected, or lets it go if all of it is pinned. */
export function togglePins(): void {
  if (!ready.value || readOnly.value) return;
  if (!baseFlat.value) notice.value = FLAT_FIRST;
  else if (allPinned()) void freePins(selection.value);
  else void setPinned(selection.value, true);
}
