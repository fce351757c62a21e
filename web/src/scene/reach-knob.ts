// SPDX-License-Identifier: MIT
// Drags of the knob on the line of the reach.
import type { Place } from "./picking.ts";

export interface KnobEvents {
  /** The pointer is here, in pixels of the canvas. */
  readonly move: (place: Place) => void;
  readonly end: () => void;
}

/** Returns how to stop listening. */
export function followKnob(
  knob: HTMLElement,
  canvas: HTMLElement,
  { move, end }: KnobEvents,
): () => void {
  const off = new AbortController();
  const { signal } = off;
  let dragging = false;
  const finish = (): void => {
    if (dragging) end();
    dragging = false;
  };
  knob.addEventListener(
    "pointerdown",
    (event) => {
      if (event.button !== 0) return;
      event.preventDefault();
      knob.setPointerCapture(event.pointerId);
      dragging = true;
    },
    { signal },
  );
  knob.addEventListener(
    "pointermove",
    ({ clientX, clientY }) => {
      const { left, top } = canvas.getBoundingClientRect();
      if (dragging) move({ x: clientX - left, y: clientY - top });
    },
    { signal },
  );
  knob.addEventListener("pointerup", finish, { signal });
  knob.addEventListener("pointercancel", finish, { signal });
  return () => off.abort();
}
