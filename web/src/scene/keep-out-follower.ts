// SPDX-License-Identifier: MIT
// Keep-outs in the view, which nothing picks, follow the state; one of them may be moved by arrows.
import { effect } from "@preact/signals";
import { keepOuts, movedInView, moveKeepOut } from "../state/keep-outs.ts";
import { fetchPart } from "../state/later.ts";
import type { Page } from "../state/page.ts";
import type { Stage } from "./stage.ts";

/** Seen on the page, light or dark, and on panels. */
const COLOURS = { light: "#C2410C", dark: "#FF9A5C" } as const;

/** Returns how to stop. */
export function followKeepOuts(page: Page, stage: Stage): () => void {
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
    const [all, mesh, moved] = [keepOuts(page).value, page.mesh.value, movedInView(page).value];
    if (!mesh || all.length === 0) return clear();
    const part = await fetchPart(page, () => import("./keep-out-drawing.ts"));
    if (mine !== turn) return;
    clear();
    const colour = dark.matches ? COLOURS.dark : COLOURS.light;
    const move = moved === null ? null : { place: moved, to: moveKeepOut };
    drawn = part?.drawKeepOuts({ page, stage, mesh, colour }, all, move) ?? null;
    stage.invalidate();
  };
  const redraw = (): void => void draw();
  dark.addEventListener("change", redraw);
  const stop = effect(redraw);
  return () => {
    ++turn;
    dark.removeEventListener("change", redraw);
    stop();
    clear();
  };
}
