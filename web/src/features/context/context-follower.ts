// SPDX-License-Identifier: MIT
// Draws what lies beside the panels while there is any; what draws it comes when it is needed.

import { effect } from "@preact/signals";
import type { Stage } from "../../scene/stage.ts";
import { fetchPart } from "../../state/later.ts";
import type { Page } from "../../state/page.ts";
import type { ContextView } from "./context-view.ts";

/** Returns how to stop. */
export function followContext(page: Page, stage: Stage, dark: MediaQueryList): () => void {
  let shown: ContextView | null = null;
  const clear = (): void => {
    if (!shown) return;
    stage.scene.remove(shown.object);
    shown.dispose();
    shown = null;
    stage.invalidate();
  };
  const recolour = (): void => shown?.setDark(dark.matches);
  dark.addEventListener("change", recolour);
  const stop = effect(() => {
    const [objects, opened] = [
      page.contextHidden.value ? null : page.context.value,
      page.mesh.value,
    ];
    clear();
    if (!objects || !opened) return;
    let gone = false;
    void fetchPart(page, () => import("./context-view.ts")).then((part) => {
      if (!part || gone) return;
      shown = new part.ContextView(objects, opened.report, dark.matches);
      stage.scene.add(shown.object);
      stage.invalidate();
    });
    return () => {
      gone = true;
    };
  });
  return () => {
    stop();
    clear();
    dark.removeEventListener("change", recolour);
  };
}
