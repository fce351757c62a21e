// SPDX-License-Identifier: MIT
// Keep-outs in the view, which nothing picks, follow the state; one of them may be moved by arrows.

import { followDrawing } from "../../scene/drawing-follower.ts";
import type { Stage } from "../../scene/stage.ts";
import { fetchPart } from "../../state/later.ts";
import type { Page } from "../../state/page.ts";
import { keepOuts, movedInView, moveKeepOut } from "./keep-outs.ts";

/** Seen on the page, light or dark, and on panels. */
const COLOURS = { light: "#C2410C", dark: "#FF9A5C" } as const;

/** Returns how to stop. */
export const followKeepOuts = (page: Page, stage: Stage): (() => void) =>
  followDrawing(stage, () => {
    const [all, mesh, moved] = [keepOuts(page).value, page.mesh.value, movedInView(page).value];
    if (!mesh || all.length === 0) return null;
    const move = moved === null ? null : { place: moved, to: moveKeepOut };
    return fetchPart(page, () => import("./keep-out-drawing.ts")).then(
      (part) =>
        part &&
        ((dark) => {
          const colour = dark ? COLOURS.dark : COLOURS.light;
          return part.drawKeepOuts({ page, stage, mesh, colour }, all, move);
        }),
    );
  });
