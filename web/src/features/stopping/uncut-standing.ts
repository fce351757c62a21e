// SPDX-License-Identifier: MIT
// What no line gives, by the design that stopped: there while the first edits are still being solved.

import type { Design, HandleRow } from "../../design/design.ts";
import { facesAt } from "../../mesh/reach.ts";
import type { SplitStanding } from "../../solver/protocol.ts";
import { shownPoint } from "../../state/editing.ts";
import type { Page } from "../../state/page.ts";

/** Of `design` and the targets asked for; null where its folds were not measured. */
export function uncutStanding(
  page: Page,
  design: Design,
  asked: readonly HandleRow[],
): SplitStanding | null {
  const mesh = page.mesh.value;
  const fold = design.report.sharpestFold;
  if (!mesh || !fold) return null;
  const short = asked.map(({ vertex, target }) => {
    const at = shownPoint(page, vertex, design.shape);
    return Math.hypot(...target.map((x, axis) => x - (at[axis] ?? 0)));
  });
  return {
    lines: 0,
    cuts: [],
    handleError: Math.max(0, ...short),
    movedVertices: design.report.movedVertices,
    // Panels with a moved corner.
    remadePanels: new Set(Array.from(design.shape.moved).flatMap((v) => facesAt(mesh, v))).size,
    sharpestFold: fold.after,
  };
}
