// SPDX-License-Identifier: MIT
// A drag moves the chosen points together: frames while it lasts, one step of the history after.
import { add, type Frame, pointFrame } from "../mesh/point-frame.ts";
import { client, frame } from "./connection.ts";
import { type HandleRow, leftBehind, type Point, withHandle } from "./design.ts";
import {
  commitEdit,
  edit,
  editQuestion,
  freePins,
  handleOf,
  setPinned,
  shownPoint,
} from "./editing.ts";
import { showPresent } from "./showing.ts";
import {
  baseFlat,
  draft,
  hintVertex,
  history,
  type Lock,
  lock,
  mesh,
  notice,
  ready,
  selection,
} from "./store.ts";
import { inTurn } from "./turns.ts";

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

const END_ON = "This direction points at you: turn the view, or type the coordinate.";

/** One drag; model units. An offset of exactly 0 along an axis keeps that coordinate's bits. */
export class Drag {
  readonly #grips: readonly Grip[];
  /** What the drag began with; a lock chosen while it lasts ends with it. */
  readonly #lock = lock.value;

  constructor(vertices: readonly number[]) {
    this.#grips = vertices.map((vertex) => ({ vertex, from: askedPoint(vertex) }));
  }

  by(offset: Point): void {
    const design = draft.value;
    if (!design) return;
    hintVertex.value = null;
    if (notice.value === END_ON) notice.value = null;
    const next = { ...design, handles: withTargets(this.#grips, offset) };
    draft.value = next;
    void frame(editQuestion(next, "drag"));
  }

  /** The line that it is held to points at the viewer: no place on screen says how far along. */
  endOn(): void {
    notice.value = END_ON;
  }

  async end(): Promise<void> {
    lock.value = this.#lock;
    client.dropStreams();
    await inTurn(async () => {
      const design = draft.value;
      if (design && design !== history.value?.present) await commitEdit(design, "release");
    });
  }

  /** Escape: the design goes back to where it was. */
  async abandon(): Promise<void> {
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
  if (!ready.value) return;
  if (!baseFlat.value) notice.value = FLAT_FIRST;
  else if (allPinned()) void freePins(selection.value);
  else void setPinned(selection.value, true);
}
