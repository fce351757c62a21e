// SPDX-License-Identifier: MIT
// Which corner or side of a panel a place in the view means.
import { Vector3 } from "three";
import { pickPanel } from "../../scene/panel-picking.ts";
import { type Place, project, type View } from "../../scene/picking.ts";
import type { Shell } from "../../scene/shell.ts";
import type { Sight } from "../../scene/sight.ts";
import type { OutlinePlace } from "./cut-text.ts";

/** Pixels about a corner that are its own, for a mouse and for a finger. */
const REACH = { fine: 10, coarse: 18 };
/** A side is cut at one of so many equal steps. */
const STEPS = 20;

type SidePlace = Extract<OutlinePlace, { from: number }>;

interface Found<P> {
  readonly place: P;
  /** Pixels. */
  readonly away: number;
}

const nearer = <P>(a: Found<P> | null, b: Found<P>): Found<P> => (a && a.away <= b.away ? a : b);

const cornersOf = ({ offsets, vertices }: Shell, panel: number): number[] => [
  ...vertices.subarray(offsets[panel] ?? 0, offsets[panel + 1] ?? 0),
];

/** Where a place on an outline is, display coordinates of the design shown. */
export function pointAt({ current }: Shell, place: OutlinePlace): Vector3 {
  if ("vertex" in place) return new Vector3().fromArray(current, 3 * place.vertex);
  const from = new Vector3().fromArray(current, 3 * place.from);
  return from.lerp(new Vector3().fromArray(current, 3 * place.to), place.share);
}

function awayFrom(shell: Shell, place: OutlinePlace, { x, y }: Place, view: View): number {
  const at = project(Float32Array.from(pointAt(shell, place).toArray()), 0, view);
  return at ? Math.hypot(at.x - x, at.y - y) : Number.POSITIVE_INFINITY;
}

/** One picks for one place of the view. */
export class CutPicking {
  readonly shell: Shell;
  readonly #at: Place;
  readonly #coarse: boolean;
  readonly #view: View;
  /** Under the place, or just beside; null beside the model. */
  readonly panel: number | null;

  constructor(sight: Sight, shell: Shell, at: Place, coarse: boolean) {
    this.shell = shell;
    this.#at = at;
    this.#coarse = coarse;
    this.#view = sight.view();
    this.panel = pickPanel(shell, at, coarse, this.#view, (place) => sight.rayThrough(place));
  }

  /** The nearest corner of a panel. */
  corner(panel: number): Found<{ readonly vertex: number }> | null {
    let found: Found<{ readonly vertex: number }> | null = null;
    for (const vertex of cornersOf(this.shell, panel)) {
      const away = awayFrom(this.shell, { vertex }, this.#at, this.#view);
      found = nearer(found, { place: { vertex }, away });
    }
    return found;
  }

  /** The nearest step of the nearest side of a panel. */
  side(panel: number): Found<SidePlace> | null {
    const corners = cornersOf(this.shell, panel);
    let found: Found<SidePlace> | null = null;
    corners.forEach((from, k) => {
      const to = corners[(k + 1) % corners.length] ?? from;
      for (let step = 1; step < STEPS; ++step) {
        const place = { from, to, share: step / STEPS };
        found = nearer(found, { place, away: awayFrom(this.shell, place, this.#at, this.#view) });
      }
    });
    return found;
  }

  /** The nearest corner, unless a side is meant. */
  outline(panel: number): OutlinePlace | null {
    const [corner, side] = [this.corner(panel), this.side(panel)];
    const reach = REACH[this.#coarse ? "coarse" : "fine"];
    return corner && corner.away <= reach ? corner.place : (side?.place ?? null);
  }

  /** Whether a place is on the outline of a panel. */
  has(panel: number, place: OutlinePlace): boolean {
    const corners = cornersOf(this.shell, panel);
    if ("vertex" in place) return corners.includes(place.vertex);
    const after = (k: number): number | undefined => corners[(k + 1) % corners.length];
    return corners.some((v, k) => {
      const [forth, back] = [v === place.from, v === place.to];
      return (forth && after(k) === place.to) || (back && after(k) === place.from);
    });
  }
}
