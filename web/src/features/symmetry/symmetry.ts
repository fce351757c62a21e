// SPDX-License-Identifier: MIT
// An edit of one point edits its images: which mirror planes and turns of the mesh that follows, and to
// change it. The base is opened again for it, evened out where it is not exactly symmetric.
import { computed } from "@preact/signals";
import { FIRST_SETTINGS } from "../../design/design.ts";
import { type Mirrors, mirrorsIn, mirrorsText } from "../../design/symmetry.ts";
import { refuse } from "../../result/result.ts";
import { enqueue, type Outcome } from "../../state/action-queue.ts";
import { commitSettings } from "../../state/editing.ts";
import { kept, type Page } from "../../state/page.ts";

const MOST_FOLDS = 360;

export const mirrors = kept((page) =>
  computed((): Mirrors => mirrorsIn((page.settings.value ?? FIRST_SETTINGS).symmetry)),
);

/** Most images that a point has, itself included; 1 without a symmetry. */
export const mostImages = kept((page) =>
  computed((): number => {
    const orbits = page.mesh.value?.symmetry?.orbits;
    if (!orbits) return 1;
    const sizes = new Map<number, number>();
    for (const orbit of orbits) sizes.set(orbit, (sizes.get(orbit) ?? 0) + 1);
    return Math.max(...sizes.values());
  }),
);

export function setMirrors(page: Page, to: Mirrors): Outcome {
  const wrong = to.turns.some((n) => n !== 0 && !(Number.isInteger(n) && n > 1 && n <= MOST_FOLDS));
  if (wrong)
    return enqueue(page, async () =>
      refuse(`Turns must be a whole number from 2 to ${MOST_FOLDS}.`),
    );
  return commitSettings(page, { symmetry: mirrorsText(to) });
}

/** All that the mesh has. */
export const findMirrors = (page: Page): Outcome => commitSettings(page, { symmetry: ["auto"] });

export const noMirrors = (page: Page): Outcome => commitSettings(page, { symmetry: [] });
