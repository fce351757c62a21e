// SPDX-License-Identifier: MIT
// What is wrong with a panel, as one class, and which panels to look at first.

import { sliverAngle } from "virtual:core-defaults";
import { FLAT } from "../design/flatness.ts";
import { PER_PANEL } from "../solver/protocol.ts";

/** The least trouble first; a panel has the place of the worst that is true of it. */
export const TROUBLES = [
  "convex",
  "sliver",
  "concave",
  "collapsed",
  "turned over",
  "crosses itself",
] as const;

/** Places in the core's PanelDamage. */
const [TURNED_OVER, COLLAPSED] = [2, 3];
/** Beyond every class of damage. */
const NOT_FLAT = 10;
/** A class is one; the sharpest fold of all is less. */
const FOLDS = 1 / 360;
const { figures: FIGURES, health: HEALTH } = PER_PANEL;

function troubleOf(outline: number, angle: number, damage: number): number {
  if (outline === 2) return 5;
  if (damage === TURNED_OVER) return 4;
  if (damage === COLLAPSED) return 3;
  if (outline === 1) return 2;
  return angle < sliverAngle ? 1 : 0;
}

/** The place of every panel in TROUBLES. `damage`: since the mesh was opened. */
export const troublesOf = (health: Float32Array, damage: Uint8Array): Float32Array =>
  Float32Array.from(damage, (kind, panel) =>
    troubleOf(health[HEALTH * panel] ?? 0, health[HEALTH * panel + 2] ?? 180, kind),
  );

/** Larger is to be looked at first: out of flat by how much, then the class, then the sharpest fold. */
export const urgencyOf = (
  troubles: Float32Array,
  figures: Float32Array,
  folds: Float32Array | null,
): Float32Array =>
  troubles.map((trouble, panel) => {
    const excess = figures[FIGURES * panel + 2] ?? 0;
    return excess > FLAT ? NOT_FLAT + excess : trouble + FOLDS * (folds?.[panel] ?? 0);
  });
