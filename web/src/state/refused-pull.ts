// SPDX-License-Identifier: MIT
// A pull further than a limit let through: the design keeps where its handles stopped.

import { computed, signal } from "@preact/signals";
import type { Design, HandleRow } from "../design/design.ts";
import { kept } from "./page.ts";

export interface RefusedPull {
  /** With the targets that were asked for. */
  readonly handles: readonly HandleRow[];
  /** Degrees by which folds might grow, by the drag's own limit; null: only stated limits act. */
  readonly growth: number | null;
  /** Whether a drag ended where its frames were held back, short of what an edit of its own may reach. */
  readonly dragged: boolean;
  /** The design that the pull ended as; null while it lasts. */
  readonly design: Design | null;
}

/** RefusedPull's growth by a pull's limit, which is infinite where only stated limits act. */
export const growthOf = (degrees: number): number | null =>
  degrees < Number.POSITIVE_INFINITY ? degrees : null;

/** The last pull that was held back; whether it still belongs to what is shown, see `refusedPull`. */
export const lastRefusedPull = kept(() => signal<RefusedPull | null>(null));

/** The refused pull that goes on, or that the present design ended as. */
export const refusedPull = kept((page) =>
  computed((): RefusedPull | null => {
    const pull = lastRefusedPull(page).value;
    if (!pull) return null;
    const present = page.history.value?.present;
    const belongs = pull.design === null ? page.draft.value !== present : pull.design === present;
    return belongs ? pull : null;
  }),
);

/** Panels that let an edit go no further, as far as its report names them. */
export const panelsAtLimit = kept((page) =>
  computed((): readonly number[] => {
    const { bounds, movedVertices } = page.figures.value;
    if (movedVertices === 0) return [];
    const { "keep-out": _points, ...panels } = bounds ?? {};
    return [...new Set(Object.values(panels).flat())];
  }),
);
