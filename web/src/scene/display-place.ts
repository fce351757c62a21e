// SPDX-License-Identifier: MIT
import type { Point } from "../design/design.ts";
import type { Page } from "../state/page.ts";

/** Where the view has a place of the model, display coordinates. */
export function displayPlace(page: Page, at: Point): Point {
  const { centre, scale } = page.mesh.value?.report ?? { centre: [0, 0, 0] as const, scale: 1 };
  const along = (axis: 0 | 1 | 2): number => (at[axis] - centre[axis]) * scale;
  return [along(0), along(1), along(2)];
}
