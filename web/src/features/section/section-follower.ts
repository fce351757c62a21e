// SPDX-License-Identifier: MIT

import { followDrawing } from "../../scene/drawing-follower.ts";
import { DARK, LIGHT } from "../../scene/palette.ts";
import type { Viewport } from "../../scene/viewport.ts";
import { hiddenPanels } from "../../state/hidden-panels.ts";
import { fetchPart } from "../../state/later.ts";
import type { Page } from "../../state/page.ts";
import { sectionPlane } from "../../state/shown-section.ts";
import { section } from "./section-plane.ts";

/** The cut follows the state. Returns how to stop. */
export const followSection = (page: Page, { stage, structure }: Viewport): (() => void) =>
  followDrawing(stage, () => {
    const [plane, cut, mesh] = [sectionPlane(page).value, section(page).value, page.mesh.value];
    // Each of these makes materials anew.
    page.displayMesh.value;
    page.colourBy.value;
    hiddenPanels(page).value;
    if (!plane || !cut || !mesh) return null;
    return fetchPart(page, () => import("./section-drawing.ts")).then(
      (part) =>
        part &&
        ((dark) => {
          const whole = structure();
          const colour = (dark ? DARK : LIGHT).selected;
          return whole && part.drawSection({ stage, structure: whole, mesh, colour }, plane, cut);
        }),
    );
  });
