// SPDX-License-Identifier: MIT

import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { namesOfFormats } from "../solver/file-formats.ts";
import { usePage } from "./page-context.ts";
import { openGiven } from "./pick-file.ts";

/** The whole page takes a dropped mesh. */
export function FileDrop({ children }: { children: ComponentChildren }) {
  const page = usePage();
  const over = useSignal(false);
  const drop = (event: DragEvent): void => {
    event.preventDefault();
    over.value = false;
    const file = event.dataTransfer?.files[0];
    if (file && page.ready.value && !page.readOnly.value) void openGiven(page, file);
  };
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: the button Open file does the same
    <div
      class={`app${over.value ? " dropping" : ""}`}
      onDragOver={(event) => {
        event.preventDefault();
        over.value = true;
      }}
      onDragLeave={(event) => {
        if (event.relatedTarget === null) over.value = false;
      }}
      onDrop={drop}
    >
      {children}
      {over.value && (
        <div class="drop-note">{`Drop an ${namesOfFormats("3dm")} file, or a design (JSON)`}</div>
      )}
    </div>
  );
}
