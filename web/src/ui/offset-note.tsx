// SPDX-License-Identifier: MIT
import "./offset-note.css";
import { effect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { onChanges } from "../state/connection.ts";
import { layOut, offsetWords, removeOffset } from "../state/offset.ts";
import { mesh, offsetChoice, offsetLayer } from "../state/store.ts";

/** Milliseconds without a change after which a layer is made again. */
const REST = 150;

/** Keeps the layer that of the design shown: gone while points move, made again when they rest. */
function useLayer(): void {
  useEffect(() => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    const again = (): void => {
      const choice = offsetChoice.peek();
      if (choice && !offsetLayer.peek()) void layOut(choice);
    };
    const stops = [
      onChanges(() => {
        offsetLayer.value = null;
        clearTimeout(timer);
        timer = setTimeout(again, REST);
      }),
      effect(() => {
        const laid = offsetChoice.value;
        if (laid && mesh.value !== laid.of) removeOffset();
      }),
      () => clearTimeout(timer),
    ];
    return () => {
      for (const stop of stops) stop();
    };
  }, []);
}

/** What the second layer is, and the way to be without it. */
export function OffsetNote() {
  useLayer();
  const [choice, layer] = [offsetChoice.value, offsetLayer.value];
  return (
    <section class="offset-note" aria-label="Second layer">
      <span>{choice && layer ? offsetWords(layer, choice.distance) : "Second layer…"}</span>
      <button type="button" class="button small" onClick={removeOffset}>
        Remove
      </button>
    </section>
  );
}
