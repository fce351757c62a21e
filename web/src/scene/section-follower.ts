// SPDX-License-Identifier: MIT
import { effect } from "@preact/signals";
import { hiddenPanels } from "../state/hidden-panels.ts";
import { fetchPart } from "../state/later.ts";
import type { Page } from "../state/page.ts";
import { section, sectionPlane } from "../state/section-plane.ts";
import { DARK, LIGHT } from "./palette.ts";
import type { Viewport } from "./viewport.ts";

/** The cut follows the state. Returns how to stop. */
export function followSection(page: Page, { stage, structure }: Viewport): () => void {
  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  let drawn: { dispose(): void } | null = null;
  let turn = 0;
  const clear = (): void => {
    drawn?.dispose();
    drawn = null;
    stage.invalidate();
  };
  const draw = async (): Promise<void> => {
    const mine = ++turn;
    const [plane, cut, mesh] = [sectionPlane(page).value, section(page).value, page.mesh.value];
    // Each of these makes materials anew.
    page.displayMesh.value;
    page.colourBy.value;
    hiddenPanels(page).value;
    if (!plane || !cut || !mesh) return clear();
    const part = await fetchPart(page, () => import("./section-drawing.ts"));
    const whole = structure();
    if (mine !== turn) return;
    clear();
    const colour = (dark.matches ? DARK : LIGHT).selected;
    drawn =
      (whole && part?.drawSection({ stage, structure: whole, mesh, colour }, plane, cut)) ?? null;
    stage.invalidate();
  };
  const stop = effect(() => void draw());
  return () => {
    ++turn;
    stop();
    clear();
  };
}
