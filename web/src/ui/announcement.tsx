// SPDX-License-Identifier: MIT

import { fingerDrag } from "../state/finger-drag.ts";
import type { Page } from "../state/page.ts";
import { usePage } from "./page-context.ts";
import { meaning } from "./point-figure.tsx";

function selectionWords(page: Page): string {
  const vertex = page.selected.value;
  const count = page.selection.value.length;
  if (vertex === null) return "";
  const offer = fingerDrag(page).value ? ". Keep it, or take it back" : "";
  if (count > 1) return `${count} points selected, the last is point ${vertex}${offer}`;
  const row = page.handles.value.find((one) => one.vertex === vertex);
  const kind = row ? (row.pinned ? ", pinned" : ", a handle") : "";
  return `Point ${vertex} selected${kind}, ${meaning(page, vertex)}${offer}`;
}

/** Says what is selected to those who do not see it. */
export function Announcement() {
  const page = usePage();
  return (
    <p class="visually-hidden" aria-live="polite">
      {selectionWords(page)}
    </p>
  );
}
