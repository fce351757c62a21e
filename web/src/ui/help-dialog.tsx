// SPDX-License-Identifier: MIT
import { useRef } from "preact/hooks";
import { Dialog } from "./dialog.tsx";
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
      <Dialog dialog={dialog} id="help" title="How it works">
        <HelpText />
      </Dialog>
    </>
  );
}
