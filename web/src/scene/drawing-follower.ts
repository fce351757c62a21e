// SPDX-License-Identifier: MIT
// What is drawn beside the structure, anew whenever the state changes, or the page turns light or dark.
import { effect } from "@preact/signals";
import type { Stage } from "./stage.ts";

export interface Drawn {
  dispose(): void;
}

/** Puts it on the stage; null for nothing. */
type Draw = (dark: boolean) => Drawn | null;

/**
 * @param ask reads the state, fetches what draws it, and gives how to; null where there is nothing to
 * draw. Of several that are under way only the last is drawn.
 * @returns how to stop
 */
export function followDrawing(stage: Stage, ask: () => Promise<Draw | null> | null): () => void {
  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  let drawn: Drawn | null = null;
  let turn = 0;
  const put = (draw: Draw | null): void => {
    drawn?.dispose();
    drawn = draw?.(dark.matches) ?? null;
    stage.invalidate();
  };
  const redraw = async (): Promise<void> => {
    const mine = ++turn;
    const asked = ask();
    const draw = asked && (await asked);
    if (mine === turn) put(draw);
  };
  const begin = (): void => void redraw();
  dark.addEventListener("change", begin);
  const stop = effect(begin);
  return () => {
    ++turn;
    dark.removeEventListener("change", begin);
    stop();
    put(null);
  };
}
