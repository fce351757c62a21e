// SPDX-License-Identifier: MIT
import { usePage } from "../../ui/page-context.ts";
import "../../ui/offset-note.css";
import { effect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { onChanges } from "../../state/connection.ts";
import { layOut, offsetWords, removeOffset } from "./offset.ts";

/** Milliseconds without a change after which a layer is made again. */
const REST = 150;

/** Keeps the layer that of the design shown: gone while points move, made again when they rest. */
function useLayer(): void {
  const page = usePage();
  useEffect(() => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    const again = (): void => {
      const choice = page.offsetChoice.peek();
      if (choice && !page.offsetLayer.peek()) void layOut(page, choice);
    };
    const stops = [
      onChanges(page, () => {
        page.offsetLayer.value = null;
        clearTimeout(timer);
        timer = setTimeout(again, REST);
      }),
      effect(() => {
        const laid = page.offsetChoice.value;
        if (laid && page.mesh.value !== laid.of) removeOffset(page);
      }),
      () => clearTimeout(timer),
    ];
    return () => {
      for (const stop of stops) stop();
    };
  }, []);
}

/** What the second layer is, and the way to be without it. */
function OffsetNote() {
  const page = usePage();
  useLayer();
  const [choice, layer] = [page.offsetChoice.value, page.offsetLayer.value];
  return (
    <section class="offset-note" aria-label="Second layer">
      <span>{choice && layer ? offsetWords(page, layer, choice.distance) : "Second layer…"}</span>
      <button type="button" class="button small" onClick={() => removeOffset(page)}>
        Remove
      </button>
    </section>
  );
}

/** The layer is kept up for as long as one is chosen. */
export const LayerNote = () => (usePage().offsetChoice.value ? <OffsetNote /> : null);
