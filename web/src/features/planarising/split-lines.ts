// SPDX-License-Identifier: MIT
// Where the panels part that a planarising which is tried out would split, drawn over the structure.

import { followDrawing } from "../../scene/drawing-follower.ts";
import { DARK, LIGHT } from "../../scene/palette.ts";
import type { Viewport } from "../../scene/viewport.ts";
import type { OpenedMesh } from "../../solver/protocol.ts";
import { fetchPart } from "../../state/later.ts";
import type { Page } from "../../state/page.ts";

const NO_PLACES = new Float32Array(0);

type Sides = Pick<OpenedMesh, "positions" | "topology">;
type Shown = Pick<OpenedMesh, "topology"> & {
  readonly report: Pick<OpenedMesh["report"], "centre" | "scale">;
};

/** x, y, z of both ends of every side that `split` has and `opened` has not, where `split` has them;
 * display coordinates of `opened`, whose points have the same numbers. */
export function addedSides(opened: Shown, { positions, topology }: Sides): Float32Array {
  const { centre, scale } = opened.report;
  const count = positions.length / 3;
  const keys = ({ edges }: Sides["topology"]): number[] =>
    Array.from({ length: edges.length / 2 }, (_, e) => {
      const [a, b] = [edges[2 * e] ?? 0, edges[2 * e + 1] ?? 0];
      return Math.min(a, b) * count + Math.max(a, b);
    });
  const known = new Set(keys(opened.topology));
  const place = (v: number): number[] =>
    ([0, 1, 2] as const).map((axis) => ((positions[3 * v + axis] ?? 0) - centre[axis]) * scale);
  const added = keys(topology).filter((key) => !known.has(key));
  return Float32Array.from(
    added.flatMap((key) => [...place(Math.floor(key / count)), ...place(key % count)]),
  );
}

/** Returns how to stop. */
export const followSplitLines = (page: Page, { stage }: Viewport, opened: OpenedMesh) =>
  followDrawing(stage, () => {
    const preview = page.planariseTrial.value;
    if (preview.kind !== "shown" || !preview.trial.split) return null;
    const lines = addedSides(opened, preview.trial.mesh);
    if (lines.length === 0) return null;
    return fetchPart(page, () => import("../../scene/cut-drawing.ts")).then(
      (part) =>
        part && ((dark) => part.drawCut(stage, lines, NO_PLACES, (dark ? DARK : LIGHT).selected)),
    );
  });
