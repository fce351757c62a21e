// SPDX-License-Identifier: MIT
import { useSignal } from "@preact/signals";
import type { ComponentChild } from "preact";
import { useRef } from "preact/hooks";
import { candidates, chooseFirst } from "../state/comparing.ts";
import { fetchPart } from "../state/later.ts";
import { Dialog } from "./dialog.tsx";

/** The button that opens it, once there are two designs of the mesh. */
export function CompareDialog() {
  const dialog = useRef<HTMLDialogElement>(null);
  const content = useSignal<ComponentChild>(null);
  const open = async (): Promise<void> => {
    const part = await fetchPart(() => import("./compare-designs.tsx"));
    if (!part) return;
    chooseFirst();
    dialog.current?.showModal();
    content.value = <part.CompareDesigns />;
  };
  const enough = candidates.value.length > 1;
  return (
    <>
      <button
        type="button"
        class="button wide"
        disabled={!enough}
        title={enough ? "" : "Needs a snapshot of this mesh"}
        onClick={() => void open()}
      >
        Compare
      </button>
      <Dialog
        dialog={dialog}
        id="compare"
        title="Compare"
        wide
        onClose={() => {
          content.value = null;
        }}
      >
        {content.value}
      </Dialog>
    </>
  );
}
