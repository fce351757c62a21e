// SPDX-License-Identifier: MIT
// Draws what lies beside the panels while there is any; what draws it comes when it is needed.
import { followDrawing } from "../../scene/drawing-follower.ts";
import type { Sight } from "../../scene/sight.ts";
import { fetchPart } from "../../state/later.ts";

/** Returns how to stop. */
export const followContext = ({ page, stage }: Sight): (() => void) =>
  followDrawing(stage, () => {
    const objects = page.contextHidden.value ? null : page.context.value;
    const opened = page.mesh.value;
    if (!objects || !opened) return null;
    return fetchPart(page, () => import("./context-view.ts")).then(
      (part) => part && ((dark) => new part.ContextView(stage.scene, objects, opened.report, dark)),
    );
  });
