// SPDX-License-Identifier: MIT
// A finger that drags a point, and the drag that it made, are followed by what helps with both.
import type { Sight } from "../../scene/sight.ts";
import { fetchPart } from "../../state/later.ts";
import type { FingerHelp } from "./finger-help.ts";

/** Returns how to stop. */
export function followFinger(sight: Sight): () => void {
  let help: FingerHelp | null = null;
  /** null until it is asked for. */
  let coming: Promise<void> | null = null;
  const fetchHelp = async (): Promise<void> => {
    const part = await fetchPart(sight.page, () => import("./finger-help.ts"));
    if (part && coming) help = new part.FingerHelp(sight);
    // What could not be had is asked for again.
    else coming = null;
    sight.stage.invalidate();
  };
  const stops = [
    sight.finger.subscribe((finger) => {
      if (!finger) help?.hide();
      else if (coming) sight.stage.invalidate();
      else coming = fetchHelp();
    }),
    sight.lifted.subscribe(async (lifted) => {
      await coming;
      if (lifted) await help?.lifted(lifted.vertex, lifted.ended);
    }),
    sight.stage.onDrawn(() => help?.draw(sight.finger.peek())),
  ];
  return () => {
    for (const stop of stops) stop();
    coming = null;
    help?.dispose();
    help = null;
  };
}
