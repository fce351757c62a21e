// SPDX-License-Identifier: MIT
import { useSignal } from "@preact/signals";
import type { ComponentChild } from "preact";
import { useRef } from "preact/hooks";
import { fetchPart } from "../state/later.ts";
import { ready } from "../state/store.ts";
import { Dialog } from "./dialog.tsx";
import { Icon } from "./icon.tsx";

export function ShareDialog() {
  const dialog = useRef<HTMLDialogElement>(null);
  const content = useSignal<ComponentChild>(null);
  const open = async (): Promise<void> => {
    const part = await fetchPart(() => import("./shared-link.tsx"));
    const shared = await part?.share();
    if (!part || !shared) return;
    content.value = <part.SharedLink shared={shared} onClose={() => dialog.current?.close()} />;
    dialog.current?.showModal();
  };
  return (
    <>
      <button
        type="button"
        class="bar-button"
        title="Share"
        disabled={!ready.value}
        onClick={() => void open()}
      >
        <Icon name="share" />
        <span class="bar-label">Share</span>
      </button>
      <Dialog dialog={dialog} id="share" title="Share this design">
        {content.value}
      </Dialog>
    </>
  );
}
