// SPDX-License-Identifier: MIT
// The panel that a click means: the one under it, or one so narrow on screen, or just beside the
// model, that nobody can be asked to hit it to the pixel.
import type { Ray } from "three";
import { panelAt } from "../mesh/triangulation.ts";
import { type Place, project, type View } from "./picking.ts";
import { surfaceHit, type Triangles } from "./surface-hit.ts";

/** Pixels beside the model that still mean its nearest panel, for a mouse and for a finger. */
const BESIDE = { fine: 8, coarse: 16 };
/** Pixels: a panel narrower than this is seen almost from its edge. */
const NARROW = 5;
/** Pixels that a narrow panel takes from the wide ones about it. */
const GRACE = { fine: 3, coarse: 8 };
/** Nearest panels that are tried; of those hidden by others there may be many. */
const TRIES = 12;

export interface Surface extends Triangles {
  /** Of the panels' corners, which come panel by panel. */
  readonly offsets: Int32Array;
}

function panelUnder(surface: Surface, ray: Ray): number | null {
  const hit = surfaceHit(surface, ray);
  return hit && panelAt(surface.offsets, hit.corner);
}

/** The panel's corners on screen; empty if one is behind the camera. */
function outlineOf({ corners, offsets }: Surface, panel: number, view: View): Place[] {
  const outline: Place[] = [];
  for (let c = offsets[panel] ?? 0; c < (offsets[panel + 1] ?? 0); ++c) {
    const at = project(corners, c, view);
    if (!at) return [];
    outline.push(at);
  }
  return outline;
}

const nextOf = (outline: readonly Place[], k: number, from: Place): Place =>
  outline[(k + 1) % outline.length] ?? from;

/** Pixels across the narrow way: area over half the outline's length. */
function widthOf(outline: readonly Place[]): number {
  let [area, length] = [0, 0];
  outline.forEach((a, k) => {
    const b = nextOf(outline, k, a);
    area += (a.x * b.y - b.x * a.y) / 2;
    length += Math.hypot(b.x - a.x, b.y - a.y) / 2;
  });
  return length > 0 ? Math.abs(area) / length : 0;
}

/** Pixels from a place to the nearest edge. */
function distanceTo(outline: readonly Place[], { x, y }: Place): number {
  let nearest = Number.POSITIVE_INFINITY;
  outline.forEach((a, k) => {
    const b = nextOf(outline, k, a);
    const [ux, uy] = [b.x - a.x, b.y - a.y];
    const share = ((x - a.x) * ux + (y - a.y) * uy) / (ux * ux + uy * uy || 1);
    const t = Math.min(1, Math.max(0, share));
    nearest = Math.min(nearest, Math.hypot(a.x + t * ux - x, a.y + t * uy - y));
  });
  return nearest;
}

function middleOf(outline: readonly Place[]): Place {
  const sum = (axis: "x" | "y"): number => outline.reduce((total, at) => total + at[axis], 0);
  return { x: sum("x") / outline.length, y: sum("y") / outline.length };
}

interface Candidate {
  readonly panel: number;
  readonly away: number;
  readonly middle: Place;
}

/** Panels with an edge within `reach` pixels, the nearest first. */
function panelsNear(
  surface: Surface,
  place: Place,
  reach: number,
  view: View,
  narrowOnly: boolean,
): Candidate[] {
  const near: Candidate[] = [];
  for (let panel = 0; panel + 1 < surface.offsets.length; ++panel) {
    const outline = outlineOf(surface, panel, view);
    const away = distanceTo(outline, place);
    if (away > reach || (narrowOnly && widthOf(outline) >= NARROW)) continue;
    near.push({ panel, away, middle: middleOf(outline) });
  }
  return near.sort((a, b) => a.away - b.away).slice(0, TRIES);
}

/** `rayThrough`: the ray through a pixel of the view. */
export function pickPanel(
  surface: Surface,
  place: Place,
  coarse: boolean,
  view: View,
  rayThrough: (place: Place) => Ray,
): number | null {
  const size = coarse ? "coarse" : "fine";
  const hit = panelUnder(surface, rayThrough(place));
  if (hit !== null && widthOf(outlineOf(surface, hit, view)) < NARROW) return hit;
  const reach = (hit === null ? BESIDE : GRACE)[size];
  const near = panelsNear(surface, place, reach, view, hit !== null);
  const seen = near.find(({ panel, middle }) => panelUnder(surface, rayThrough(middle)) === panel);
  return seen?.panel ?? hit;
}
