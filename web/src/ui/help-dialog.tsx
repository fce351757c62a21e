// SPDX-License-Identifier: MIT
import { useRef } from "preact/hooks";
import { Icon } from "./icon.tsx";
import { later } from "./later.tsx";

const HelpText = later(() => import("./help-text.tsx").then((part) => part.HelpText));

export function HelpDialog() {
  const dialog = useRef<HTMLDialogElement>(null);
  return (
    <>
      <button
        type="button"
        class="bar-button"
        onClick={() => dialog.current?.showModal()}
        title="Help"
      >
        <Icon name="help" />
        <span class="bar-label">Help</span>
      </button>
      <dialog ref={dialog} class="dialog" aria-labelledby="help-title">
        <div class="dialog-head">
          <h2 id="help-title">How it works</h2>
          <button
            type="button"
            class="icon-button"
            aria-label="Close"
            onClick={() => dialog.current?.close()}
          >
            <Icon name="close" />
          </button>
        </div>
        <HelpText />
      </dialog>
    </>
  );
}
