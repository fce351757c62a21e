// SPDX-License-Identifier: MIT
import { handles, selected, selection } from "../state/store.ts";
import { meaning } from "./point-figure.tsx";

function words(): string {
  const vertex = selected.value;
  const count = selection.value.length;
  if (vertex === null) return "";
  if (count > 1) return `${count} points selected, the last is point ${vertex}`;
  const row = handles.value.find((one) => one.vertex === vertex);
  const kind = row ? (row.pinned ? ", pinned" : ", a handle") : "";
  return `Point ${vertex} selected${kind}, ${meaning(vertex)}`;
}

/** Says what is selected to those who do not see it. */
export function Announcement() {
  return (
    <p class="visually-hidden" aria-live="polite">
      {words()}
    </p>
  );
}
