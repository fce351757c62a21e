// SPDX-License-Identifier: MIT
// The line beyond which an edit moves nothing, softly over the panels' edges, with a knob that drags it.
import { outlineOf, type ReachLimit, ringsWithin } from "../mesh/reach.ts";
import { LineOverlay } from "./line-overlay.ts";
import { type Place, project, type View } from "./picking.ts";
import type { Shell } from "./shell.ts";

/** Rings that the knob can go to, as the slider. */
const MOST = 12;
/** Pixels. */
const WIDTH = 6;
const OPACITY = 0.32;

export class ReachLine extends LineOverlay {
  /** Where it runs. */
  #points: readonly number[] = [];
  #seeds: readonly number[] = [];
  #key = "";

  constructor() {
    super({ linewidth: WIDTH, transparent: true, opacity: OPACITY, depthWrite: false });
  }

  /** Draws the line around `seeds`; none, or no limit: no line. */
  draw(shell: Shell, seeds: readonly number[], limit: ReachLimit): void {
    const key = [seeds, limit.rings, limit.length].join();
    if (key === this.#key) return;
    this.#key = key;
    this.#seeds = seeds;
    const limited = seeds.length > 0 && (limit.rings > 0 || limit.length > 0);
    this.#points = limited
      ? outlineOf(structureOf(shell), ringsWithin(structureOf(shell), seeds, limit).keys())
      : [];
    const lines = this.#points.flatMap((v) => [...shell.base.subarray(3 * v, 3 * v + 3)]);
    this.set(lines);
  }

  /** Another mesh is shown. */
  forget(): void {
    this.#key = "";
  }

  /** Where its knob is: at the right of it; null without a line, or where that is out of view. */
  knob({ base }: Shell, view: View): Place | null {
    let found: Place | null = null;
    for (const v of this.#points) {
      const at = project(base, v, view);
      if (at && (!found || at.x + at.y / 2 > found.x + found.y / 2)) found = at;
    }
    const inside = found && found.x < view.width && found.y < view.height && found.y > 0;
    return inside ? found : null;
  }

  /** The reach, in rings, whose line runs through the point nearest to `place`. */
  ringsAt(shell: Shell, place: Place, view: View): number {
    const limit = { rings: MOST + 1, length: 0 };
    let [nearest, rings] = [Number.POSITIVE_INFINITY, 1];
    for (const [v, ring] of ringsWithin(structureOf(shell), this.#seeds, limit)) {
      const at = project(shell.base, v, view);
      const gap = at ? Math.hypot(at.x - place.x, at.y - place.y) : Number.POSITIVE_INFINITY;
      if (gap < nearest) [nearest, rings] = [gap, ring];
    }
    return Math.min(MOST, Math.max(1, rings - 1));
  }
}

const structureOf = ({ base, offsets, vertices, topology }: Shell) => ({
  display: base,
  offsets,
  vertices,
  topology,
});
