// SPDX-License-Identifier: MIT
// How keys are spelled, and where they mean letters or steps instead of commands.
import type { Heard } from "./command.ts";

/**
 * "Ctrl+Shift+Z", "F6", "Shift+ArrowLeft", "1", "+": Ctrl stands for ⌘ too, and Shift is said only where
 * the same key means something else with it.
 */
export function spelled(event: KeyboardEvent): string {
  const { ctrlKey, metaKey, altKey, shiftKey } = event;
  const key = event.key.length === 1 ? event.key.toUpperCase() : event.key;
  const shift = shiftKey && key !== key.toLowerCase();
  return `${ctrlKey || metaKey ? "Ctrl+" : ""}${altKey ? "Alt+" : ""}${shift ? "Shift+" : ""}${key}`;
}

/** Whether text is typed here. */
const takesText = (target: EventTarget | null): boolean =>
  target instanceof HTMLInputElement && target.type !== "range" && target.type !== "checkbox";

/** Whether letters typed here are words, or keys are for an open menu. */
const takesLetters = (target: EventTarget | null): boolean =>
  takesText(target) ||
  target instanceof HTMLSelectElement ||
  document.querySelector(":popover-open") !== null;

/** Whether arrows move or scroll something here. */
const takesArrows = (target: EventTarget | null): boolean =>
  target instanceof HTMLInputElement || (target instanceof Element && !!target.closest("aside"));

/** Whether keys pressed at `target` are for a command that is heard so. What lies under a dialog hears
 * none. */
export function isHeard(heard: Heard | undefined, target: EventTarget | null): boolean {
  if (document.querySelector(":modal") !== null) return false;
  if (heard === "everywhere") return true;
  if (heard === "view") return !takesLetters(target);
  if (heard === "arrows") return !takesLetters(target) && !takesArrows(target);
  return !takesText(target);
}
