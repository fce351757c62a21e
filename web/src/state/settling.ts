// SPDX-License-Identifier: MIT
// What a drag showed last, and the design that it ended as: the same shape, or points went on as it settled.
import { signal } from "@preact/signals";
import type { Design } from "../design/design.ts";
import { kept } from "./page.ts";

export interface Settling {
  readonly design: Design;
  /** How far a point went at most from where the last frame had it; model units. */
  readonly most: number;
  /** The longest way that a handle was asked to go; model units. */
  readonly pull: number;
}

/** Of the last drag that ended. */
export const lastSettling = kept(() => signal<Settling | null>(null));
