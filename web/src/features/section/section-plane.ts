// SPDX-License-Identifier: MIT
// What the plane that cuts the view open cuts, and where it can be.
import { computed } from "@preact/signals";
import { NO_SHAPE } from "../../design/design.ts";
import { extentOf } from "../../mesh/extent.ts";
import { cutPanels, type PlaneSection } from "../../mesh/plane-section.ts";
import { kept, type Page } from "../../state/page.ts";
import { sectionPlane } from "../../state/shown-section.ts";

/** The design shown, model units; three numbers a point. */
const shownPoints = kept((page) =>
  computed((): Float64Array => {
    const mesh = page.mesh.value;
    if (!mesh) return new Float64Array(0);
    const points = mesh.positions.slice();
    const { moved, positions } = page.draft.value?.shape ?? NO_SHAPE;
    moved.forEach((v, k) => {
      points.set(positions.subarray(3 * k, 3 * k + 3), 3 * v);
    });
    return points;
  }),
);

/** What the plane cuts, model units; null without one. */
export const section = kept((page) =>
  computed((): PlaneSection | null => {
    const [plane, mesh] = [sectionPlane(page).value, page.mesh.value];
    return plane && mesh && cutPanels(shownPoints(page).value, mesh, plane.axis, plane.at);
  }),
);

/** Of the base along an axis, model units. */
export function rangeAlong(page: Page, axis: 0 | 1 | 2): readonly [number, number] {
  const { low, high } = extentOf(page.mesh.value?.positions ?? [0, 0, 0]);
  return [low[axis], high[axis]];
}

/** Through the middle of the structure, or the point chosen last; null takes it away. */
export function cutAcross(page: Page, axis: 0 | 1 | 2 | null): void {
  if (axis === null) {
    sectionPlane(page).value = null;
    return;
  }
  const chosen = page.selection.value.at(-1);
  const [low, high] = rangeAlong(page, axis);
  const through = chosen === undefined ? undefined : shownPoints(page).value[3 * chosen + axis];
  sectionPlane(page).value = { axis, at: through ?? (low + high) / 2, flipped: false };
}
