// SPDX-License-Identifier: MIT
// While panels are cut, clicks in the view are the tool's, and what it is about to cut is drawn there.
import { followDrawing } from "../../scene/drawing-follower.ts";
import { DARK, LIGHT } from "../../scene/palette.ts";
import { viewTool } from "../../scene/view-tool.ts";
import type { Viewport } from "../../scene/viewport.ts";
import { fetchPart } from "../../state/later.ts";
import type { Page } from "../../state/page.ts";
import { pointAt } from "./cut-picking.ts";
import { CutTool } from "./cut-tool.ts";
import { begin, begun, followTrial, point, pointed, trialNow } from "./cutting.ts";

const NO_LINES = new Float32Array(0);

/** Where the cut begins and would go, display coordinates. */
function placesOf(page: Page, { sight }: Viewport): Float32Array {
  const { shell } = sight;
  const places = [begun(page)?.place, pointed(page)?.place].flatMap((one) => one ?? []);
  return shell
    ? Float32Array.from(places.flatMap((place) => pointAt(shell, place).toArray()))
    : NO_LINES;
}

const followPreview = (page: Page, view: Viewport): (() => void) =>
  followDrawing(view.stage, () => {
    const [lines, places] = [trialNow(page)?.lines ?? NO_LINES, placesOf(page, view)];
    if (lines.length === 0 && places.length === 0) return null;
    return fetchPart(page, () => import("../../scene/cut-drawing.ts")).then(
      (part) =>
        part && ((dark) => part.drawCut(view.stage, lines, places, (dark ? DARK : LIGHT).selected)),
    );
  });

/** Returns how to stop. */
export function followCutting(page: Page, view: Viewport | null): () => void {
  const tool = viewTool(page);
  const stops = [followTrial(page)];
  if (view) {
    tool.value = new CutTool(page, view.sight);
    stops.push(followPreview(page, view));
  }
  return () => {
    for (const stop of stops) stop();
    tool.value = null;
    begin(page, null);
    point(page, null);
  };
}
