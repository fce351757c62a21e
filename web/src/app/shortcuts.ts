// SPDX-License-Identifier: MIT
import { redo, undo } from "../state/editing.ts";
import { readOnly, ready, showBefore } from "../state/store.ts";
import { pickAndOpen } from "../ui/pick-file.ts";
import { takesLetters } from "../ui/view-keys.ts";

const typing = (target: EventTarget | null): boolean =>
  target instanceof HTMLInputElement && target.type !== "range" && target.type !== "checkbox";

function down(event: KeyboardEvent): void {
  if (event.key === "F6") {
    event.preventDefault();
    void import("./regions.ts").then((regions) => regions.goToRegion(event.shiftKey ? -1 : 1));
    return;
  }
  if (typing(event.target) || readOnly.value) return;
  const command = event.ctrlKey || event.metaKey;
  const key = event.key.toLowerCase();
  if (command && (key === "y" || (key === "z" && event.shiftKey))) {
    event.preventDefault();
    void redo();
  } else if (command && key === "z") {
    event.preventDefault();
    void undo();
  } else if (command && key === "o") {
    event.preventDefault();
    if (ready.value) void pickAndOpen();
  } else if (!command && !event.altKey && key === "b" && !takesLetters(event.target)) {
    showBefore.value = true;
  }
}

function up(event: KeyboardEvent): void {
  if (event.key.toLowerCase() === "b") showBefore.value = false;
}

/** Undo, redo, F6 from region to region, and B held for before/after. Returns how to stop listening. */
export function listenToShortcuts(): () => void {
  const off = new AbortController();
  window.addEventListener("keydown", down, { signal: off.signal });
  window.addEventListener("keyup", up, { signal: off.signal });
  window.addEventListener(
    "blur",
    () => {
      showBefore.value = false;
    },
    { signal: off.signal },
  );
  return () => off.abort();
}
