// SPDX-License-Identifier: MIT
// The 3D view of the page, for commands that turn it, fit it or step from point to point.
import type { Viewport } from "../scene/viewport.ts";
import { kept, type Page } from "../state/page.ts";

const slot = kept((): { view: Viewport | null } => ({ view: null }));

/** null while there is none. */
export const viewOf = (page: Page): Viewport | null => slot(page).view;

/** Makes a canvas the view; it shows the focus unless that came by the pointer. Returns how to
 * take it away again. */
export function offerView(page: Page, canvas: HTMLCanvasElement, view: Viewport): () => void {
  const off = new AbortController();
  const byPointer = (on: boolean) => () => canvas.classList.toggle("by-pointer", on);
  canvas.addEventListener("pointerdown", byPointer(true), { signal: off.signal });
  canvas.addEventListener("blur", byPointer(false), { signal: off.signal });
  slot(page).view = view;
  return () => {
    off.abort();
    slot(page).view = null;
  };
}
